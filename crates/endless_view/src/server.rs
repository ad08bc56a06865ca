//! Connections: who may come, how much a head may hold, how long it may take.

use crate::{dataset::Dataset, error::ViewError, folder::DatasetFolder, refusal::Refusal, router::router};
use axum::Router;
use hyper::server::conn::http1;
use hyper_util::{
    rt::{TokioIo, TokioTimer},
    service::TowerToHyperService,
};
use std::{
    io,
    net::{IpAddr, SocketAddr, TcpListener},
    path::PathBuf,
    sync::Arc,
    time::Duration,
};
use tokio::{
    net::TcpStream,
    sync::{Notify, Semaphore},
};

/// Most bytes and lines of a request's head, and how long it may take to come.
const HEAD_BYTES: usize = 16 << 10;
const HEAD_LINES: usize = 64;
const HEAD_TIME: Duration = Duration::from_secs(15);
/// Most connections at once.
const MOST_CONNECTIONS: usize = 256;
/// Threads that read files and make pictures.
const READERS: usize = 8;

/// What to show, and where to listen.
#[derive(Debug, Clone)]
pub struct ViewSettings {
    /// Folder of the dataset.
    pub folder: PathBuf,
    /// Address on which to listen.
    pub bind: IpAddr,
    /// Port, 0 for any that is free.
    pub port: u16,
}

/// A server that listens, and answers once it runs.
#[derive(Debug)]
pub struct Viewer {
    listener: TcpListener,
    address: SocketAddr,
    dataset: Arc<Dataset>,
    stopper: Stopper,
}

/// Ends a viewer from another thread.
#[derive(Debug, Clone, Default)]
pub struct Stopper(Arc<Notify>);

impl Stopper {
    /// Lets [`Viewer::run`] return.
    pub fn stop(&self) {
        self.0.notify_one();
    }
}

impl Viewer {
    /// Opens the dataset and begins to listen.
    ///
    /// # Errors
    /// When there is no dataset that can be read, or the port is not free.
    pub fn bind(settings: &ViewSettings) -> Result<Self, ViewError> {
        let folder = settings.folder.clone();
        let Ok(opened) = DatasetFolder::new(&folder) else { return Err(ViewError::NoDataset { folder }) };
        let dataset = Arc::new(Dataset::new(opened));
        match dataset.manifest() {
            Ok(_) => {}
            Err(Refusal::Missing(_)) => return Err(ViewError::NoDataset { folder }),
            Err(refusal) => return Err(ViewError::Unreadable { reason: refusal.to_string(), folder }),
        }
        let address = SocketAddr::new(settings.bind, settings.port);
        let listener = TcpListener::bind(address).map_err(|cause| match cause.kind() {
            io::ErrorKind::AddrInUse => ViewError::PortInUse { address },
            _ => ViewError::Listen { address, cause },
        })?;
        let address = listener.local_addr().map_err(|cause| ViewError::Listen { address, cause })?;
        Ok(Self { listener, address, dataset, stopper: Stopper::default() })
    }

    /// Where it listens.
    pub fn address(&self) -> SocketAddr {
        self.address
    }

    /// What ends it.
    pub fn stopper(&self) -> Stopper {
        self.stopper.clone()
    }

    /// Answers until it is stopped.
    ///
    /// # Errors
    /// When the operating system gives no threads.
    pub fn run(self) -> Result<(), ViewError> {
        let runtime = tokio::runtime::Builder::new_multi_thread()
            .worker_threads(2)
            .max_blocking_threads(READERS)
            .enable_io()
            .enable_time()
            .build()
            .map_err(ViewError::Start)?;
        let Self { listener, address, dataset, stopper } = self;
        let listen = || {
            listener.set_nonblocking(true)?;
            let _inside = runtime.enter();
            tokio::net::TcpListener::from_std(listener)
        };
        let listener = listen().map_err(ViewError::Start)?;
        runtime.spawn(accept(listener, router(dataset, address.ip())));
        runtime.block_on(stopper.0.notified());
        runtime.shutdown_background();
        Ok(())
    }
}

/// Takes connections for ever.
async fn accept(listener: tokio::net::TcpListener, router: Router) {
    let room = Arc::new(Semaphore::new(MOST_CONNECTIONS));
    while let Ok(place) = Arc::clone(&room).acquire_owned().await {
        match listener.accept().await {
            Ok((stream, _)) => {
                let answers = answer(stream, router.clone());
                drop(tokio::spawn(async move {
                    answers.await;
                    drop(place);
                }));
            }
            // Too many files are open, or whoever came has gone: the next one may fare better.
            Err(_cause) => tokio::time::sleep(Duration::from_millis(20)).await,
        }
    }
}

/// Answers all requests of a connection.
async fn answer(stream: TcpStream, router: Router) {
    // Answers are written whole; a connection without it is only slower.
    let _ = stream.set_nodelay(true);
    let mut connection = http1::Builder::new();
    connection.timer(TokioTimer::new()).header_read_timeout(HEAD_TIME);
    connection.max_buf_size(HEAD_BYTES).max_headers(HEAD_LINES);
    let service = TowerToHyperService::new(router);
    if let Err(cause) = connection.serve_connection(TokioIo::new(stream), service).await {
        tracing::debug!("a connection ended: {cause}");
    }
}
