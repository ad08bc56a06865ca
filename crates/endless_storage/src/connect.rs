//! Opens what an address names, with the settings and credentials of the environment.

use crate::{
    address::{Provider, StorageAddress},
    error::{Problem, StorageError},
};
use object_store::{
    BackoffConfig, ObjectStore, RetryConfig, aws::AmazonS3Builder, azure::MicrosoftAzureBuilder,
    gcp::GoogleCloudStorageBuilder, prefix::PrefixStore,
};
use std::{sync::Arc, time::Duration};

/// How long the first request waits for a server, at most: most often an address or an endpoint is wrong.
const FIRST_PATIENCE: Duration = Duration::from_secs(10);

/// Clients of one bucket, whose names begin where the address ends.
#[derive(Debug, Clone)]
pub(crate) struct Clients {
    /// For the first request.
    pub(crate) first: Arc<dyn ObjectStore>,
    /// For all others.
    pub(crate) store: Arc<dyn ObjectStore>,
}

impl Clients {
    /// Clients which repeat a request that fails for so long.
    pub(crate) fn open(address: &StorageAddress, patience: Duration) -> Result<Self, StorageError> {
        // Another part of the program may have installed one, which is as good.
        let _ = rustls::crypto::ring::default_provider().install_default();
        Ok(Self { first: open(address, patience.min(FIRST_PATIENCE))?, store: open(address, patience)? })
    }
}

fn open(address: &StorageAddress, patience: Duration) -> Result<Arc<dyn ObjectStore>, StorageError> {
    let backoff = BackoffConfig {
        init_backoff: Duration::from_millis(100),
        max_backoff: Duration::from_secs(10).min(patience),
        base: 2.0,
    };
    // As often as there is time.
    let retry = RetryConfig { backoff, max_retries: 1000, retry_timeout: patience };
    let bucket = &address.bucket;
    let opened = match address.provider {
        Provider::S3 => {
            let builder = AmazonS3Builder::from_env().with_bucket_name(bucket).with_retry(retry);
            builder.build().map(|store| below(store, &address.prefix))
        }
        Provider::Google => {
            let builder = GoogleCloudStorageBuilder::from_env().with_bucket_name(bucket).with_retry(retry);
            builder.build().map(|store| below(store, &address.prefix))
        }
        Provider::Azure => {
            let builder = MicrosoftAzureBuilder::from_env().with_container_name(bucket).with_retry(retry);
            builder.build().map(|store| below(store, &address.prefix))
        }
    };
    // What exactly is wrong is not told: it may hold a key.
    opened.map_err(|_may_hold_secrets| StorageError {
        action: "cannot open the storage",
        problem: Problem::Settings(address.provider),
        name: address.to_string(),
    })
}

fn below(store: impl ObjectStore, prefix: &str) -> Arc<dyn ObjectStore> {
    Arc::new(PrefixStore::new(store, prefix))
}
