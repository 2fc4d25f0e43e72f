//! Connections: each is accepted, served by the routes, and bounded in number and in the time its requests take to arrive.

use crate::routes::routes;
use crate::work::Workers;
use crate::{ServeError, Settings};
use axum::Router;
use hyper::server::conn::http1;
use hyper_util::rt::{TokioIo, TokioTimer};
use hyper_util::service::TowerToHyperService;
use std::io;
use std::net::SocketAddr;
use std::sync::Arc;
use std::time::Duration;
use tokio::net::{TcpListener, TcpStream};
use tokio::sync::Semaphore;
use tokio::time::timeout;

/// Connections at once; more wait to be accepted.
const CONNECTIONS: usize = 256;
/// The time that the head of a request may take to arrive.
const HEAD: Duration = Duration::from_secs(10);
/// The time that a connection may last, or four times as long as a piece of work if that is more: a client that does not read
/// its replies gives up its place then.
const LIFETIME: Duration = Duration::from_secs(600);
/// The time before the next connection is tried to be accepted when the system refused one.
const PAUSE: Duration = Duration::from_millis(50);

/// Listens, announces the address and serves until the process is asked to end.
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
    // work that is left ends with the runtime: its processes are killed when their handles are dropped
    Ok(())
}

/// Accepts connections for ever.
async fn accept(listener: TcpListener, routes: Router, lifetime: Duration) {
    let free = Arc::new(Semaphore::new(CONNECTIONS));
    loop {
        let Ok(place) = free.clone().acquire_owned().await else { return };
        let Ok((stream, _)) = listener.accept().await else {
            tokio::time::sleep(PAUSE).await;
            continue;
        };
        let routes = routes.clone();
        tokio::spawn(async move {
            let _ = timeout(lifetime, connection(stream, routes)).await;
            drop(place);
        });
    }
}

/// Serves one connection; what its client does wrong ends it and nothing else.
async fn connection(stream: TcpStream, routes: Router) {
    let service = TowerToHyperService::new(routes);
    let mut server = http1::Builder::new();
    server.timer(TokioTimer::new()).header_read_timeout(HEAD);
    let _ = server.serve_connection(TokioIo::new(stream), service).await;
}

/// Waits for Ctrl-C, and on Unix for the signal to terminate.
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
