//! Long searches for cheaper programs, offline; what they find is left as recipes.

use super::source;
use ga_codegen::factor::{
    Search, expanded_count, factor, pack, read_recipe, replay, replay_packed, write_packed_recipe, write_recipe,
};
use ga_codegen::kernel::{Definition, Kernel};
use ga_codegen::program::{Count, PackedProgram};
use ga_codegen::proof::prove;
use ga_codegen::{Task, tasks};
use indicatif::{ProgressBar, ProgressStyle};
use proc_macro2::{TokenStream, TokenTree};
use serde_json::{Map, Value, json};
use std::collections::BTreeMap;
use std::fs;
use std::io::ErrorKind;
use std::path::{Path, PathBuf};
use std::sync::Mutex;
use std::sync::atomic::{AtomicUsize, Ordering};

/// What is asked for.
pub(crate) struct Request {
    pub(crate) source: String,
    pub(crate) kernels: Vec<String>,
    pub(crate) restarts: u64,
    pub(crate) fresh: bool,
    pub(crate) output: Option<PathBuf>,
}

fn key(task: &Task) -> String {
    if task.packed { format!("{} packed", task.recipe) } else { format!("{} {}", task.recipe, task.model) }
}

/// A number that another specification, or another set of starting points, does not share (FNV-1a).
fn fingerprint(task: &Task) -> u64 {
    let names = task.specification.names();
    let polynomials = task.specification.outputs.iter().chain(&task.specification.stated);
    let text: String = polynomials.map(|polynomial| polynomial.display(&names) + ";").collect();
    let text = format!("{} {} {text}", env!("CARGO_PKG_VERSION"), task.model);
    text.bytes().fold(0xcbf2_9ce4_8422_2325, |hash, byte| (hash ^ u64::from(byte)).wrapping_mul(0x0100_0000_01b3))
}

/// What a job leaves behind.
struct Found {
    place: Place,
    recipe: Option<String>,
    line: String,
}

/// Searches every kernel that sharing can make cheaper; returns the log, and the recipes where no file is named.
pub(crate) fn run(request: &Request) -> Result<String, String> {
    let definition = source::definition(&request.source)?;
    let known = |name: &String| definition.kernels.iter().any(|kernel| is_of(kernel, name));
    if let Some(name) = request.kernels.iter().find(|name| !known(name)) {
        return Err(format!("error: expected a kernel of {}, found `{name}`", request.source));
    }
    let old = recipes_in(request)?;
    let jobs = jobs(&definition, request)?;
    let state = Mutex::new(State::read(request.output.as_deref(), request.fresh)?);
    let bar = ProgressBar::new(request.restarts.saturating_mul(jobs.len() as u64));
    let style = ProgressStyle::with_template("{bar:40} {pos}/{len} restarts, {eta} left  {msg}");
    bar.set_style(style.map_err(|error| format!("error: {error}"))?);
    let next = AtomicUsize::new(0);
    let found: Vec<Mutex<Option<Found>>> = jobs.iter().map(|_| Mutex::new(None)).collect();
    std::thread::scope(|scope| {
        let threads = std::thread::available_parallelism().map_or(1, usize::from);
        let work = || work(request, &jobs, &next, &found, &state, &bar);
        let workers: Vec<_> = (0..threads).map(|_| scope.spawn(work)).collect();
        workers.into_iter().try_for_each(|worker| worker.join().expect("invariant: a worker does not panic"))
    })?;
    bar.finish_and_clear();
    let mut log = String::new();
    let mut recipes = kept(&definition, &old);
    for slot in found {
        let found = slot.into_inner().ok().flatten().ok_or("error: a search did not finish")?;
        log += &found.line;
        recipes.insert(found.place, found.recipe.unwrap_or_default());
    }
    let recipes: String = recipes.into_values().collect();
    match &request.output {
        Some(path) => {
            write(path, &recipes)?;
            Ok(log)
        }
        None => Ok(format!("{log}\n{recipes}")),
    }
}

/// Where a recipe stands among those of a definition: the kernel, the program.
type Place = (usize, usize);

/// Whether a name is that of a kernel, of one of its variants or of one of its parts.
fn is_of(kernel: &Kernel, name: &str) -> bool {
    let variant = kernel.models.iter().any(|model| name == format!("{}_{model}", kernel.name));
    let packed = kernel.packed.is_some() && name == kernel.packed_name();
    packed || variant || kernel.name == name || kernel.models.iter().any(|&model| kernel.has_program(name, model))
}

/// The text of the output file, which must be recipes and nothing else: it will be replaced.
fn recipes_in(request: &Request) -> Result<String, String> {
    let Some(path) = &request.output else { return Ok(String::new()) };
    let refuse =
        |found: String| format!("error: {}: expected a file of recipes to replace, found {found}", path.display());
    let text = match fs::read_to_string(path) {
        Ok(text) => text,
        Err(error) if error.kind() == ErrorKind::NotFound => return Ok(String::new()),
        Err(error) => return Err(refuse(error.to_string())),
    };
    let tokens: TokenStream = text.parse().map_err(|error: proc_macro2::LexError| refuse(error.to_string()))?;
    let mut tokens = tokens.into_iter();
    while let Some(token) = tokens.next() {
        let rest: Vec<TokenTree> = tokens.by_ref().take(3).collect();
        match (token.to_string().as_str(), rest.as_slice()) {
            ("recipe", [TokenTree::Ident(_), TokenTree::Ident(_), TokenTree::Group(_)]) => {}
            (found, _) => return Err(refuse(format!("`{found}`"))),
        }
    }
    Ok(text)
}

/// Writes a file whole or not at all.
fn write(path: &Path, text: &str) -> Result<(), String> {
    let unfinished = path.with_extension("unfinished");
    let written = fs::write(&unfinished, text).and_then(|()| fs::rename(&unfinished, path));
    written.map_err(|error| format!("error: {}: {error}", path.display()))
}

/// Recipes by the programs of the definition that they belong to.
fn kept(definition: &Definition, text: &str) -> BTreeMap<Place, String> {
    let places: BTreeMap<String, Place> = definition
        .kernels
        .iter()
        .enumerate()
        .flat_map(|(kernel, found)| {
            let tasks = tasks(definition, found).unwrap_or_default();
            tasks.into_iter().enumerate().map(move |(task, found)| (key(&found), (kernel, task)))
        })
        .collect();
    let starts: Vec<_> = text.match_indices("recipe ").map(|(start, _)| start).collect();
    let ends = starts.iter().skip(1).copied().chain([text.len()]);
    let recipes = starts.iter().zip(ends).map(|(&start, end)| &text[start..end]);
    let placed = recipes.filter_map(|recipe| {
        let key = recipe.strip_prefix("recipe ")?.split(" {").next()?;
        Some((*places.get(key)?, recipe.to_owned()))
    });
    placed.collect()
}

/// Kernels and the places of their programs.
fn jobs(definition: &Definition, request: &Request) -> Result<Vec<Place>, String> {
    let mut jobs = Vec::new();
    let asked = |kernel: &Kernel| request.kernels.is_empty() || request.kernels.iter().any(|name| is_of(kernel, name));
    for (index, kernel) in definition.kernels.iter().enumerate() {
        if kernel.analytic.is_none() && asked(kernel) {
            let tasks = tasks(definition, kernel).map_err(|error| source::describe(&request.source, &error))?;
            jobs.extend((0..tasks.len()).map(|task| (index, task)));
        }
    }
    Ok(jobs)
}

/// Takes jobs until none is left. Definitions stay in their thread, so every worker reads its own.
fn work(
    request: &Request,
    jobs: &[Place],
    next: &AtomicUsize,
    found: &[Mutex<Option<Found>>],
    state: &Mutex<State>,
    bar: &ProgressBar,
) -> Result<(), String> {
    let definition = source::definition(&request.source)?;
    loop {
        let index = next.fetch_add(1, Ordering::Relaxed);
        let (Some(&(kernel, task)), Some(slot)) = (jobs.get(index), found.get(index)) else { return Ok(()) };
        let tasks = tasks(&definition, &definition.kernels[kernel])
            .map_err(|error| source::describe(&request.source, &error))?;
        let result = search(&definition, (kernel, task), &tasks[task], request, state, bar)?;
        *slot.lock().expect("invariant: no thread panics with the lock") = Some(result);
    }
}

fn search(
    definition: &Definition,
    place: Place,
    task: &Task,
    request: &Request,
    state: &Mutex<State>,
    bar: &ProgressBar,
) -> Result<Found, String> {
    if task.packed {
        bar.set_message(key(task));
        let found = search_packed(definition, place, task);
        bar.inc(request.restarts);
        return found;
    }
    let fail = |error: String| format!("error: {}: {error}", task.recipe);
    let lock = || state.lock().expect("invariant: no thread panics with the lock");
    let mut search =
        Search::new(&task.specification, task.model, &task.recipe).map_err(|error| fail(error.to_string()))?;
    if !request.fresh
        && let Some(recipe) = definition.recipe(&task.recipe, task.model)
        && let Ok(program) = replay(&task.specification, recipe)
        && prove(&task.specification, &program).is_ok()
    {
        search.know(program);
    }
    let mut done = lock().take(task, &mut search);
    bar.set_message(key(task));
    bar.inc(done.restarts.min(request.restarts));
    while done.restarts < request.restarts {
        if search.restart(done.restarts) {
            done.found_at = done.restarts + 1;
        }
        done.restarts += 1;
        bar.inc(1);
        if done.restarts.is_multiple_of(SAVE_EVERY) {
            lock().put(task, &done, &search)?;
        }
    }
    lock().put(task, &done, &search)?;
    finish(place, task, &search, &done).map_err(fail)
}

/// A packed program for a product, or the recipe that there is where it is no dearer. There are no restarts.
fn search_packed(definition: &Definition, place: Place, task: &Task) -> Result<Found, String> {
    let proved = |program: &PackedProgram| prove(&task.specification, &program.unpack()).is_ok();
    let known = definition.packed_recipe(&task.recipe);
    let known = known.and_then(|recipe| replay_packed(&task.specification, recipe).ok());
    let programs = known.into_iter().chain(pack(&task.specification)).filter(proved);
    let best = programs.min_by_key(|program| program.count().total()).ok_or_else(|| {
        format!(
            "error: {}: expected a product of two types with fields in groups of four, or a packed recipe that fits, found \
             neither",
            task.recipe
        )
    })?;
    let line = format!("{}: {}\n", key(task), best.count());
    Ok(Found { place, recipe: Some(write_packed_recipe(&task.specification, &best, &task.recipe)), line })
}

const SAVE_EVERY: u64 = 500;

/// The log line, and the recipe where it beats or replaces what expansion would have to search for itself.
fn finish(place: Place, task: &Task, search: &Search, done: &Done) -> Result<Found, String> {
    let best = search.best().ok_or("no program was found")?;
    prove(&task.specification, best).map_err(|refutation| refutation.to_string())?;
    let expanded = expanded_count(&task.specification).map_err(|error| error.to_string())?.unwrap_or_default();
    let quick = factor(&task.specification, task.model).map_err(|error| error.to_string())?;
    let (count, quick) = (Count::of(best), Count::of(&quick));
    let line = format!(
        "{} {}: {}+{} ({} FMA, depth {}) from {}+{} expanded, {}+{} without search; {} starting points, {} restarts, found at {}\n",
        task.recipe,
        task.model,
        count.mul,
        count.add,
        count.fma,
        count.depth,
        expanded.mul,
        expanded.add,
        quick.mul,
        quick.add,
        search.starting_points(),
        done.restarts,
        done.found_at,
    );
    let worth = count.flops() < expanded.flops() || task.model.cost(count) < task.model.cost(quick);
    let recipe = worth.then(|| write_recipe(&task.specification, best, &task.recipe, task.model));
    Ok(Found { place, recipe, line })
}

/// How far every search has come, beside the recipes' file, so that an interrupted search goes on.
struct State {
    path: Option<PathBuf>,
    entries: Map<String, Value>,
}

struct Done {
    restarts: u64,
    found_at: u64,
}

impl State {
    fn read(output: Option<&Path>, fresh: bool) -> Result<Self, String> {
        let path = output.map(|path| path.with_extension("search.json"));
        let Some(file) = path.as_ref().filter(|file| !fresh && file.exists()) else {
            return Ok(Self { path, entries: Map::new() });
        };
        let refuse = |found: String| {
            format!("error: {}: expected the state of a search, found {found}; --fresh starts anew", file.display())
        };
        let text = fs::read_to_string(file).map_err(|error| refuse(error.to_string()))?;
        let entries = serde_json::from_str(&text).map_err(|error| refuse(format!("other JSON ({error})")))?;
        Ok(Self { path, entries })
    }

    /// What was done for this job; the best program found goes to the search.
    fn take(&self, task: &Task, search: &mut Search) -> Done {
        let entry = self.entries.get(&key(task));
        let number = |field: &str| entry.and_then(|entry| entry.get(field)).and_then(Value::as_u64).unwrap_or(0);
        let same = number("specification") == fingerprint(task);
        let recipe = entry.and_then(|entry| entry.get("recipe")).and_then(Value::as_str).filter(|_| same);
        let program = recipe.and_then(|text| read_recipe(&task.specification, text).ok());
        match program.filter(|program| prove(&task.specification, program).is_ok()) {
            Some(program) => {
                search.know(program);
                Done { restarts: number("restarts"), found_at: number("found_at") }
            }
            None => Done { restarts: 0, found_at: 0 },
        }
    }

    fn put(&mut self, task: &Task, done: &Done, search: &Search) -> Result<(), String> {
        let Some(path) = &self.path else { return Ok(()) };
        let recipe = search.best().map(|best| write_recipe(&task.specification, best, &task.recipe, task.model));
        let entry = json!({ "specification": fingerprint(task), "restarts": done.restarts, "found_at": done.found_at, "recipe": recipe });
        self.entries.insert(key(task), entry);
        let text = serde_json::to_string_pretty(&self.entries).map_err(|error| format!("error: {error}"))?;
        write(path, &text)
    }
}
