//! What the factoriser finds without a search.

/// Sums are as shallow as can be where latency counts, and a kernel that is a product of products is made in stages.
#[test]
fn the_cost_model_and_the_stages_count() {
    let block = "
signature (3, 0, 0);
entity Even { s: 1, e23, e13, e12 }
entity Vector { x: e1, y: e2, z: e3 }
kernel product(a: Even, b: Even) -> Even = a * b cost flops, latency;
kernel square(a: Vector, b: Vector) -> Scalar = (a | b) * (a | b);
";
    let definition = ga_codegen::define(block.parse().expect("tokens")).expect("a block");
    let programs = ga_codegen::compile(&definition).expect("proofs");
    let counts: Vec<_> = programs.iter().map(|one| ga_codegen::program::Count::of(&one.program)).collect();
    assert_eq!((counts[0].mul, counts[0].add, counts[0].depth), (16, 12, 4));
    assert_eq!((counts[1].mul, counts[1].add, counts[1].depth), (16, 12, 3));
    assert_eq!((counts[2].mul, counts[2].add), (4, 2));
}
