//! Objects of a bucket: listed, read, written and removed, many at a time.

use crate::{
    address::{Provider, StorageAddress},
    connect::Clients,
    error::{Problem, StorageError},
};
use bytes::Bytes;
use futures_util::{StreamExt, TryStreamExt, stream};
use object_store::{ObjectStore, ObjectStoreExt, WriteMultipart, path::Path as Key};
use std::{
    collections::{BTreeMap, BTreeSet},
    fs::File,
    future::Future,
    io::Read,
    path::Path,
    time::Duration,
};

/// Requests at a time. Most objects are small, so that it is the time of an answer that counts.
const REQUESTS_AT_A_TIME: usize = 16;
/// Files of more bytes are put in pieces of so many.
const PIECE_BYTES: usize = 8 << 20;
/// Pieces of one file that are on their way at a time.
const PIECES_AT_A_TIME: usize = 4;

/// Sizes of objects by their names.
pub(crate) type Objects = BTreeMap<String, u64>;

/// The objects below an address.
#[derive(Debug, Clone)]
pub(crate) struct Bucket {
    clients: Clients,
    provider: Provider,
    /// The address, for messages.
    name: String,
}

impl Bucket {
    pub(crate) fn open(address: &StorageAddress, patience: Duration) -> Result<Self, StorageError> {
        let clients = Clients::open(address, patience)?;
        Ok(Self { clients, provider: address.provider, name: address.to_string() })
    }

    #[cfg(test)]
    pub(crate) fn of(store: std::sync::Arc<dyn ObjectStore>) -> Self {
        let clients = Clients { first: std::sync::Arc::clone(&store), store };
        Self { clients, provider: Provider::S3, name: "s3://test".to_owned() }
    }

    fn failed(&self, action: &'static str, name: &str) -> impl Fn(object_store::Error) -> StorageError {
        let problem = |error: &object_store::Error| Problem::of(error, self.provider);
        move |error| StorageError { action, problem: problem(&error), name: self.name_of(name) }
    }

    /// Something is wrong with an object.
    pub(crate) fn error(&self, action: &'static str, problem: Problem, name: &str) -> StorageError {
        StorageError { action, problem, name: self.name_of(name) }
    }

    fn name_of(&self, name: &str) -> String {
        if name.is_empty() { self.name.clone() } else { format!("{}/{name}", self.name) }
    }

    /// Whether the bucket answers: fails soon if it does not.
    pub(crate) async fn knock(&self) -> Result<(), StorageError> {
        let mut listed = self.clients.first.list(Some(&Key::from("dataset.json")));
        listed.try_next().await.map_err(self.failed("cannot list", ""))?;
        Ok(())
    }

    /// Objects in a folder and all below it.
    pub(crate) async fn list(&self, folder: &str) -> Result<Objects, StorageError> {
        let listed = self.clients.store.list(Some(&Key::from(folder)));
        let skip = if folder.is_empty() { 0 } else { folder.len() + 1 };
        let named = listed.map_ok(|object| {
            let name = object.location.as_ref().get(skip..).unwrap_or_default().to_owned();
            (name, object.size)
        });
        named.try_collect().await.map_err(self.failed("cannot list", folder))
    }

    /// Names of the folders in a folder.
    pub(crate) async fn folders(&self, folder: &str) -> Result<BTreeSet<String>, StorageError> {
        let listed = self.clients.store.list_with_delimiter(Some(&Key::from(folder))).await;
        let listed = listed.map_err(self.failed("cannot list", folder))?;
        Ok(listed.common_prefixes.iter().filter_map(|key| Some(key.filename()?.to_owned())).collect())
    }

    /// The bytes of an object; none if there is no such object.
    pub(crate) async fn get(&self, name: &str) -> Result<Option<Bytes>, StorageError> {
        let failed = self.failed("cannot download", name);
        match self.clients.store.get(&Key::from(name)).await {
            Err(object_store::Error::NotFound { source, path }) => {
                let error = object_store::Error::NotFound { source, path };
                // A bucket that is not there is no missing object.
                if Problem::of(&error, self.provider) == Problem::NoObject { Ok(None) } else { Err(failed(error)) }
            }
            Err(error) => Err(failed(error)),
            Ok(found) => found.bytes().await.map(Some).map_err(failed),
        }
    }

    /// Writes the bytes of an object.
    pub(crate) async fn put(&self, name: &str, bytes: Bytes) -> Result<(), StorageError> {
        let put = self.clients.store.put(&Key::from(name), bytes.into()).await;
        put.map(drop).map_err(self.failed("cannot upload", name))
    }

    /// Writes a file as an object.
    pub(crate) async fn put_file(&self, name: &str, path: &Path) -> Result<(), StorageError> {
        let unreadable = |e| self.error("cannot upload", Problem::Disk(format!("cannot read the file ({e})")), name);
        let mut file = File::open(path).map_err(unreadable)?;
        let bytes = file.metadata().map_err(unreadable)?.len();
        if bytes <= PIECE_BYTES as u64 {
            let mut all = Vec::with_capacity(bytes as usize);
            file.read_to_end(&mut all).map_err(unreadable)?;
            return self.put(name, all.into()).await;
        }
        let failed = self.failed("cannot upload", name);
        let upload = self.clients.store.put_multipart(&Key::from(name)).await.map_err(&failed)?;
        let mut upload = WriteMultipart::new_with_chunk_size(upload, PIECE_BYTES);
        loop {
            let mut piece = Vec::with_capacity(PIECE_BYTES);
            file.by_ref().take(PIECE_BYTES as u64).read_to_end(&mut piece).map_err(unreadable)?;
            if piece.is_empty() {
                return upload.finish().await.map(drop).map_err(failed);
            }
            if let Err(error) = upload.wait_for_capacity(PIECES_AT_A_TIME).await {
                // What is there of it costs space; who cannot be asked to remove it does so after a while, if told to.
                let _ = upload.abort().await;
                return Err(failed(error));
            }
            upload.put(piece.into());
        }
    }

    /// Removes an object, if it is there.
    pub(crate) async fn remove(&self, name: &str) -> Result<(), StorageError> {
        match self.clients.store.delete(&Key::from(name)).await {
            Ok(()) | Err(object_store::Error::NotFound { .. }) => Ok(()),
            Err(error) => Err(self.failed("cannot remove", name)(error)),
        }
    }
}

/// Does something to all items, many at a time, and stops at the first failure.
pub(crate) async fn for_all<I, F: Future<Output = Result<(), StorageError>>>(
    items: impl IntoIterator<Item = I>,
    each: impl Fn(I) -> F,
) -> Result<(), StorageError> {
    stream::iter(items).map(each).buffer_unordered(REQUESTS_AT_A_TIME).try_collect().await
}
