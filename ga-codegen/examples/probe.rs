//! probe
use ga_codegen::factor::*;
use ga_codegen::program::Count;
use ga_codegen::*;
fn main() {
    let args: Vec<String> = std::env::args().collect();
    let secs: f64 = args[1].parse().unwrap();
    let d = define(preset::text("pga3d").unwrap().parse().unwrap()).unwrap();
    for k in &d.kernels {
        if k.analytic.is_some() {
            continue;
        }
        if args.len() > 2 && !args[2..].iter().any(|n| k.name.contains(n.as_str())) {
            continue;
        }
        let s = kernel::Specification::new(&d, k).unwrap();
        for model in [CostModel::Flops, CostModel::Fma] {
            let t = std::time::Instant::now();
            let mut search = Search::new(&s, model, &k.name).unwrap();
            let g = Count::of(search.best().unwrap());
            let mut n = 0;
            let mut at = 0;
            while t.elapsed().as_secs_f64() < secs {
                if search.restart(n) {
                    at = n;
                }
                n += 1;
            }
            let b = Count::of(search.best().unwrap());
            proof::prove(&s, search.best().unwrap()).unwrap();
            println!(
                "{} {}: starts {} greedy {}+{} fma {} -> best {}+{} fma {} depth {} (restart {at} of {n})",
                k.name,
                model,
                search.starting_points(),
                g.mul,
                g.add,
                g.fma,
                b.mul,
                b.add,
                b.fma,
                b.depth
            );
        }
    }
}
