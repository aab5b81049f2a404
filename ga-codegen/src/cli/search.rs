//! Long searches for cheaper programs, offline; what they find is left as recipes.

use super::source;
use ga_codegen::factor::{Search, expanded_count, factor, read_recipe, replay, write_recipe};
use ga_codegen::kernel::{Definition, Kernel, Specification};
use ga_codegen::program::{CostModel, Count};
use ga_codegen::proof::prove;
use indicatif::{ProgressBar, ProgressStyle};
use serde_json::{Map, Value, json};
use std::fs;
use std::path::{Path, PathBuf};
use std::sync::Mutex;
use std::sync::atomic::{AtomicUsize, Ordering};

/// What is asked for.
pub(crate) struct Request {
    pub(crate) source: String,
    pub(crate) kernels: Vec<String>,
    pub(crate) restarts: u64,
    pub(crate) output: Option<PathBuf>,
}

/// One program to look for, and what has come of it.
struct Job<'a> {
    kernel: &'a Kernel,
    model: CostModel,
    specification: Specification,
}

impl Job<'_> {
    fn key(&self) -> String {
        format!("{} {}", self.kernel.name, self.model)
    }
}

/// What a job leaves behind.
struct Found {
    recipe: Option<String>,
    line: String,
}

/// Searches every kernel that sharing can make cheaper; returns the log, and the recipes where no file is named.
pub(crate) fn run(request: &Request) -> Result<String, String> {
    let definition = source::definition(&request.source)?;
    if let Some(name) = request.kernels.iter().find(|name| definition.kernel(name).is_none()) {
        return Err(format!("error: expected a kernel of {}, found `{name}`", request.source));
    }
    let jobs = jobs(&definition, request);
    let state = Mutex::new(State::read(request.output.as_deref())?);
    let bar = ProgressBar::new(request.restarts * jobs.len() as u64);
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
    let (mut log, mut recipes) = (String::new(), String::new());
    for slot in found {
        let found = slot.into_inner().ok().flatten().ok_or("error: a search did not finish")?;
        log += &found.line;
        recipes += found.recipe.as_deref().unwrap_or_default();
    }
    match &request.output {
        Some(path) => {
            fs::write(path, recipes).map_err(|error| format!("error: {}: {error}", path.display()))?;
            Ok(log)
        }
        None => Ok(format!("{log}\n{recipes}")),
    }
}

/// Kernels and cost models, by their places in the definition.
fn jobs(definition: &Definition, request: &Request) -> Vec<(usize, CostModel)> {
    let asked = |kernel: &Kernel| request.kernels.is_empty() || request.kernels.contains(&kernel.name);
    let polynomial = |(_, kernel): &(usize, &Kernel)| kernel.analytic.is_none() && asked(kernel);
    let kernels = definition.kernels.iter().enumerate().filter(polynomial);
    kernels.flat_map(|(index, kernel)| kernel.models.iter().map(move |&model| (index, model))).collect()
}

/// Takes jobs until none is left. Definitions stay in their thread, so every worker reads its own.
fn work(
    request: &Request,
    jobs: &[(usize, CostModel)],
    next: &AtomicUsize,
    found: &[Mutex<Option<Found>>],
    state: &Mutex<State>,
    bar: &ProgressBar,
) -> Result<(), String> {
    let definition = source::definition(&request.source)?;
    loop {
        let index = next.fetch_add(1, Ordering::Relaxed);
        let (Some(&(kernel, model)), Some(slot)) = (jobs.get(index), found.get(index)) else { return Ok(()) };
        let kernel = &definition.kernels[kernel];
        let specification =
            Specification::new(&definition, kernel).map_err(|error| format!("error: {}: {error}", kernel.name))?;
        let result = search(&definition, &Job { kernel, model, specification }, request, state, bar)?;
        *slot.lock().expect("invariant: no thread panics with the lock") = Some(result);
    }
}

fn search(
    definition: &Definition,
    job: &Job<'_>,
    request: &Request,
    state: &Mutex<State>,
    bar: &ProgressBar,
) -> Result<Found, String> {
    let (name, model) = (&job.kernel.name, job.model);
    let fail = |error: String| format!("error: {name}: {error}");
    let lock = || state.lock().expect("invariant: no thread panics with the lock");
    let mut search = Search::new(&job.specification, model, name).map_err(|error| fail(error.to_string()))?;
    if let Some(recipe) = definition.recipe(name, model)
        && let Ok(program) = replay(&job.specification, recipe)
        && prove(&job.specification, &program).is_ok()
    {
        search.know(program);
    }
    let mut done = lock().take(job, &mut search);
    bar.set_message(format!("{name} {model}"));
    bar.inc(done.restarts.min(request.restarts));
    while done.restarts < request.restarts {
        if search.restart(done.restarts) {
            done.found_at = done.restarts + 1;
        }
        done.restarts += 1;
        bar.inc(1);
        if done.restarts.is_multiple_of(SAVE_EVERY) {
            lock().put(job, &done, &search)?;
        }
    }
    lock().put(job, &done, &search)?;
    finish(job, &search, &done).map_err(fail)
}

const SAVE_EVERY: u64 = 500;

/// The log line, and the recipe where it beats or replaces what expansion would have to search for itself.
fn finish(job: &Job<'_>, search: &Search, done: &Done) -> Result<Found, String> {
    let best = search.best().ok_or("no program was found")?;
    prove(&job.specification, best).map_err(|refutation| refutation.to_string())?;
    let expanded = expanded_count(&job.specification).map_err(|error| error.to_string())?.unwrap_or_default();
    let quick = factor(&job.specification, job.model).map_err(|error| error.to_string())?;
    let (count, quick) = (Count::of(best), Count::of(&quick));
    let line = format!(
        "{} {}: {}+{} ({} FMA, depth {}) from {}+{} expanded, {}+{} without search; {} starting points, {} restarts, found at {}\n",
        job.kernel.name,
        job.model,
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
    let worth = count.flops() < expanded.flops() || job.model.cost(count) < job.model.cost(quick);
    let recipe = worth.then(|| write_recipe(&job.specification, best, &job.kernel.name, job.model));
    Ok(Found { recipe, line })
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
    fn read(output: Option<&Path>) -> Result<Self, String> {
        let path = output.map(|path| path.with_extension("search.json"));
        let text = match path.as_ref().map(fs::read_to_string) {
            Some(Ok(text)) => text,
            _ => return Ok(Self { path, entries: Map::new() }),
        };
        let entries = serde_json::from_str(&text).map_err(|error| {
            let path = path.as_deref().unwrap_or(Path::new("")).display();
            format!("error: {path}: expected the state of a search, found other JSON: {error}")
        })?;
        Ok(Self { path, entries })
    }

    /// What was done for this job; the best program found goes to the search.
    fn take(&self, job: &Job<'_>, search: &mut Search) -> Done {
        let entry = self.entries.get(&job.key());
        let number = |field: &str| entry.and_then(|entry| entry.get(field)).and_then(Value::as_u64).unwrap_or(0);
        let recipe = entry.and_then(|entry| entry.get("recipe")).and_then(Value::as_str);
        let program = recipe.and_then(|text| read_recipe(&job.specification, text).ok());
        match program.filter(|program| prove(&job.specification, program).is_ok()) {
            Some(program) => {
                search.know(program);
                Done { restarts: number("restarts"), found_at: number("found_at") }
            }
            None => Done { restarts: 0, found_at: 0 },
        }
    }

    fn put(&mut self, job: &Job<'_>, done: &Done, search: &Search) -> Result<(), String> {
        let Some(path) = &self.path else { return Ok(()) };
        let recipe = search.best().map(|best| write_recipe(&job.specification, best, &job.kernel.name, job.model));
        let entry = json!({ "restarts": done.restarts, "found_at": done.found_at, "recipe": recipe });
        self.entries.insert(job.key(), entry);
        let text = serde_json::to_string_pretty(&self.entries).map_err(|error| format!("error: {error}"))?;
        fs::write(path, text).map_err(|error| format!("error: {}: {error}", path.display()))
    }
}
