//! Work on all cores that Ctrl-C can end.

use std::sync::atomic::{AtomicBool, Ordering};
use std::sync::mpsc::{self, RecvTimeoutError};
use std::sync::{Arc, Mutex};
use std::thread;
use std::time::Duration;

use pyo3::prelude::*;
use rayon::{ThreadPool, ThreadPoolBuilder};

/// How long work goes on before the interpreter is asked for signals.
const PATIENCE: Duration = Duration::from_millis(50);
/// Bytes of stack for each thread: a second attempt of a large interpreted plan takes 8 MiB.
const STACK: usize = 32 << 20;

/// The threads, and the process that they belong to.
static POOL: Mutex<Option<(u32, Arc<ThreadPool>)>> = Mutex::new(None);

/// The threads of this process. A process that was forked has none of its parent's.
fn pool() -> Option<Arc<ThreadPool>> {
    let process = std::process::id();
    let mut pool = POOL.lock().ok()?;
    if let Some((owner, threads)) = pool.as_ref()
        && *owner == process
    {
        return Some(Arc::clone(threads));
    }
    let threads = Arc::new(ThreadPoolBuilder::new().stack_size(STACK).build().ok()?);
    // Threads of the parent cannot be joined here.
    std::mem::forget(pool.replace((process, Arc::clone(&threads))));
    Some(threads)
}

/// Does work on all cores without the lock of the interpreter. The work asks the flag whether it
/// must end. Between whiles `each` is called with the lock.
///
/// # Errors
/// That of a signal handler, such as `KeyboardInterrupt`, or of `each`.
pub(crate) fn interruptible<T: Send>(
    py: Python<'_>,
    work: impl FnOnce(&AtomicBool) -> T + Send,
    mut each: impl FnMut(Python<'_>) -> PyResult<()> + Send,
) -> PyResult<T> {
    let is_over = AtomicBool::new(false);
    py.detach(|| {
        let (sender, receiver) = mpsc::channel();
        thread::scope(|scope| {
            let is_over = &is_over;
            let builder = thread::Builder::new().stack_size(STACK);
            let on_pool = move || match pool() {
                Some(pool) => pool.install(|| work(is_over)),
                None => work(is_over),
            };
            builder.spawn_scoped(scope, move || sender.send(on_pool()))?;
            loop {
                match receiver.recv_timeout(PATIENCE) {
                    Ok(result) => return Ok(result),
                    Err(RecvTimeoutError::Timeout) => {}
                    Err(RecvTimeoutError::Disconnected) => {
                        return Err(pyo3::exceptions::PyRuntimeError::new_err("a thread of the solver ended early"));
                    }
                }
                let asked = Python::attach(|py| py.check_signals().and_then(|()| each(py)));
                asked.inspect_err(|_| is_over.store(true, Ordering::Relaxed))?;
            }
        })
    })
}
