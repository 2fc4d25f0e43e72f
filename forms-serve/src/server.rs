//! Connections: each is accepted and served by the routes. Their number, and the time in which
//! requests must arrive, are bounded.

use crate::routes::routes;
use crate::work::Workers;
use crate::{ServeError, Settings};
use axum::Router;
use axum::extract::{Request, State};
use axum::middleware::{Next, from_fn_with_state};
use axum::response::Response;
use hyper::server::conn::http1;
use hyper_util::rt::{TokioIo, TokioTimer};
use hyper_util::service::TowerToHyperService;
use std::collections::VecDeque;
use std::io;
use std::net::SocketAddr;
use std::sync::Arc;
use std::sync::atomic::{AtomicUsize, Ordering};
use std::time::Duration;
use tokio::net::{TcpListener, TcpStream};
use tokio::sync::Semaphore;
use tokio::task::JoinHandle;
use tokio::time::timeout;

/// Limit of simultaneous connections.
const CONNECTIONS: usize = 256;
/// Time limit for the head of a request to arrive.
const HEAD: Duration = Duration::from_secs(10);
/// Longest duration of a connection; four times the time limit of a request if that is longer. A
/// client that does not read its replies loses its connection after this time.
const LIFETIME: Duration = Duration::from_secs(600);
/// Delay before the next attempt to accept a connection after the system has refused one.
const PAUSE: Duration = Duration::from_millis(50);

/// Listens, announces the address, and serves until the process is asked to end.
pub(crate) async fn run(
    settings: Settings,
    announce: impl FnOnce(SocketAddr) -> io::Result<()>,
) -> Result<(), ServeError> {
    let wanted = SocketAddr::new(settings.bind, settings.port);
    let listener = TcpListener::bind(wanted).await.map_err(|error| match error.kind() {
        io::ErrorKind::AddrInUse => ServeError::PortTaken(wanted),
        _ => ServeError::Address(wanted, error),
    })?;
    let address = listener.local_addr().map_err(|error| ServeError::Address(wanted, error))?;
    let lifetime = LIFETIME.max(settings.time_limit.saturating_mul(4));
    let workers = Workers::new(settings.worker, settings.time_limit);
    let routes = routes(Arc::new(workers), settings.opened, settings.words);
    announce(address).map_err(ServeError::Announcement)?;
    tokio::select! {
        () = accept(listener, routes, lifetime) => {}
        () = asked_to_end() => {}
    }
    // Unfinished work ends with the runtime: its processes are killed when their handles are
    // dropped.
    Ok(())
}

/// Accepts connections for ever. At the limit, the oldest idle connection is closed, so clients
/// that connect and send nothing do not block others.
async fn accept(listener: TcpListener, routes: Router, lifetime: Duration) {
    let free = Arc::new(Semaphore::new(CONNECTIONS));
    let mut open: VecDeque<Open> = VecDeque::new();
    loop {
        let Ok((stream, _)) = listener.accept().await else {
            tokio::time::sleep(PAUSE).await;
            continue;
        };
        open.retain(|connection| !connection.task.is_finished());
        if free.available_permits() == 0
            && let Some(idle) = open.iter().position(Open::is_idle)
            && let Some(idle) = open.remove(idle)
        {
            idle.task.abort();
        }
        let Ok(place) = free.clone().acquire_owned().await else { return };
        let requests = Arc::new(AtomicUsize::new(0));
        let routes = routes.clone().layer(from_fn_with_state(Arc::clone(&requests), counted));
        let task = tokio::spawn(async move {
            let _ = timeout(lifetime, connection(stream, routes)).await;
            drop(place);
        });
        open.push_back(Open { task, requests });
    }
}

/// Accepted connection.
struct Open {
    task: JoinHandle<()>,
    /// Number of requests being answered.
    requests: Arc<AtomicUsize>,
}

impl Open {
    fn is_idle(&self) -> bool {
        self.requests.load(Ordering::Relaxed) == 0
    }
}

/// Counts a request while it is being answered.
async fn counted(State(requests): State<Arc<AtomicUsize>>, request: Request, next: Next) -> Response {
    struct Answered(Arc<AtomicUsize>);
    impl Drop for Answered {
        fn drop(&mut self) {
            self.0.fetch_sub(1, Ordering::Relaxed);
        }
    }
    requests.fetch_add(1, Ordering::Relaxed);
    let _answered = Answered(requests);
    next.run(request).await
}

/// Serves one connection. An error of its client ends this connection only.
async fn connection(stream: TcpStream, routes: Router) {
    let service = TowerToHyperService::new(routes);
    let mut server = http1::Builder::new();
    server.timer(TokioTimer::new()).header_read_timeout(HEAD);
    let _ = server.serve_connection(TokioIo::new(stream), service).await;
}

/// Waits for Ctrl-C, and on Unix also for the signal to terminate.
async fn asked_to_end() {
    #[cfg(unix)]
    {
        use tokio::signal::unix::{SignalKind, signal};
        if let Ok(mut terminate) = signal(SignalKind::terminate()) {
            tokio::select! {
                _ = tokio::signal::ctrl_c() => {}
                _ = terminate.recv() => {}
            }
            return;
        }
    }
    let _ = tokio::signal::ctrl_c().await;
}
