//! Addresses of datasets: `s3://bucket/prefix` and the like.

use std::{fmt, path::PathBuf, str::FromStr};

/// Who keeps the objects.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Provider {
    /// Amazon S3, and servers that speak its protocol.
    S3,
    /// Google Cloud Storage.
    Google,
    /// Azure Blob Storage; its buckets are called containers.
    Azure,
}

impl Provider {
    /// All there are.
    pub const ALL: [Self; 3] = [Self::S3, Self::Google, Self::Azure];

    /// What its addresses begin with, before `://`.
    pub const fn scheme(self) -> &'static str {
        match self {
            Self::S3 => "s3",
            Self::Google => "gs",
            Self::Azure => "az",
        }
    }
}

/// A place in a bucket: `s3://bucket/prefix`.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct StorageAddress {
    /// Who keeps it.
    pub provider: Provider,
    /// The bucket.
    pub bucket: String,
    /// What all names there begin with, without slashes at its ends; may be empty.
    pub prefix: String,
}

impl fmt::Display for StorageAddress {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let slash = if self.prefix.is_empty() { "" } else { "/" };
        write!(f, "{}://{}{slash}{}", self.provider.scheme(), self.bucket, self.prefix)
    }
}

/// Where a dataset is.
#[derive(Debug, Clone, PartialEq, Eq)]
pub enum DatasetAddress {
    /// A folder, as a path or as `file:///absolute/path`.
    Folder(PathBuf),
    /// Object storage.
    Storage(StorageAddress),
}

/// What cannot be an address. It never repeats what may be secret.
#[derive(Debug, Clone, Copy, PartialEq, Eq, thiserror::Error)]
pub enum AddressError {
    /// Nobody keeps datasets at such addresses.
    #[error(
        "unknown kind of address: use s3://BUCKET/PREFIX, gs://BUCKET/PREFIX, az://CONTAINER/PREFIX, file:///PATH or a path"
    )]
    UnknownScheme,
    /// A key in an address would be written to logs.
    #[error("an address must not hold a user, a password or a key: give them in the environment (docs/storage.md)")]
    Secret,
    /// No bucket.
    #[error("the address names no bucket: use {0}://BUCKET/PREFIX")]
    NoBucket(&'static str),
    /// A character that buckets or names cannot have.
    #[error(
        "the address has a character or a part that names of objects cannot have: use letters, digits, '-', '_', '.' and '/'"
    )]
    BadName,
    /// The program was built without.
    #[error(
        "this build of endless has no object storage: build it with `--features cloud`, or use the Python package, which has it \
         (docs/storage.md)"
    )]
    NotBuilt,
    /// A command that works on this machine alone.
    #[error(
        "this command reads folders alone: copy the dataset to one, for example with `aws s3 sync` (docs/storage.md)"
    )]
    NotAFolder,
    /// Not an absolute path.
    #[error("an address of a folder has three slashes: file:///absolute/path")]
    RelativeFile,
}

impl FromStr for DatasetAddress {
    type Err = AddressError;

    fn from_str(text: &str) -> Result<Self, AddressError> {
        let Some((scheme, rest)) = text.split_once("://") else { return Ok(Self::Folder(text.into())) };
        let known = Provider::ALL.into_iter().find(|provider| provider.scheme().eq_ignore_ascii_case(scheme));
        let is_file = scheme.eq_ignore_ascii_case("file");
        if known.is_none() && !is_file {
            return Err(AddressError::UnknownScheme);
        }
        if is_file {
            return if rest.starts_with('/') { Ok(Self::Folder(rest.into())) } else { Err(AddressError::RelativeFile) };
        }
        let Some(provider) = known else { return Err(AddressError::UnknownScheme) };
        if rest.contains(['@', '?', '#', '&', '=']) {
            return Err(AddressError::Secret);
        }
        let (bucket, prefix) = rest.split_once('/').unwrap_or((rest, ""));
        if bucket.is_empty() {
            return Err(AddressError::NoBucket(provider.scheme()));
        }
        let prefix = prefix.trim_end_matches('/');
        if !bucket.chars().all(is_plain) || !(prefix.is_empty() || prefix.split('/').all(is_plain_part)) {
            return Err(AddressError::BadName);
        }
        Ok(Self::Storage(StorageAddress { provider, bucket: bucket.to_owned(), prefix: prefix.to_owned() }))
    }
}

/// Characters that every provider takes as they are.
fn is_plain(c: char) -> bool {
    c.is_ascii_alphanumeric() || matches!(c, '-' | '_' | '.')
}

fn is_plain_part(part: &str) -> bool {
    !part.is_empty() && part != "." && part != ".." && part.chars().all(is_plain)
}

#[cfg(test)]
mod tests {
    use super::*;
    use proptest::prelude::*;

    fn parse(text: &str) -> Result<DatasetAddress, AddressError> {
        text.parse()
    }

    #[test]
    fn addresses_and_paths() {
        let storage = |provider, bucket: &str, prefix: &str| {
            let (bucket, prefix) = (bucket.to_owned(), prefix.to_owned());
            Ok(DatasetAddress::Storage(StorageAddress { provider, bucket, prefix }))
        };
        assert_eq!(parse("s3://bucket/a/b/"), storage(Provider::S3, "bucket", "a/b"));
        assert_eq!(parse("GS://bucket"), storage(Provider::Google, "bucket", ""));
        assert_eq!(parse("az://container/a"), storage(Provider::Azure, "container", "a"));
        assert_eq!(parse("out/a"), Ok(DatasetAddress::Folder("out/a".into())));
        assert_eq!(parse("file:///data/out 1"), Ok(DatasetAddress::Folder("/data/out 1".into())));
        assert_eq!(parse("file://data/out"), Err(AddressError::RelativeFile));
        assert_eq!(parse("http://bucket/a"), Err(AddressError::UnknownScheme));
        assert_eq!(parse("s3:///a"), Err(AddressError::NoBucket("s3")));
        for bad in ["s3://bucket//a", "s3://bucket/../a", "s3://bucket/a b", "s3://bück/a", "s3://bucket/a%2f"] {
            assert_eq!(parse(bad), Err(AddressError::BadName), "{bad}");
        }
    }

    #[test]
    fn secrets_are_refused_and_not_repeated() {
        for bad in ["s3://AKIA:hunter2@bucket/a", "az://container/a?sig=hunter2", "gs://bucket/a#hunter2"] {
            let refused = parse(bad).expect_err("refused");
            assert_eq!(refused, AddressError::Secret);
            assert!(!refused.to_string().contains("hunter2"));
        }
    }

    proptest! {
        #[test]
        fn what_is_printed_is_read_again(text in "(s3|gs|az)://[a-z@./?0-9 ]{0,20}") {
            if let Ok(DatasetAddress::Storage(address)) = parse(&text) {
                prop_assert_eq!(parse(&address.to_string()), Ok(DatasetAddress::Storage(address)));
            }
        }
    }
}
