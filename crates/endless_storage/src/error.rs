//! What a storage server refuses, in words that say what to do, and never with a secret: of what servers and libraries say,
//! only codes and causes are told, neither addresses of requests nor bodies.

use crate::address::Provider;
use endless_pipeline::StoreError;
use std::{error::Error, fmt};

/// Storage that cannot be used. One line that says what to do.
#[derive(Debug, thiserror::Error)]
#[error("{action}: {problem}: {name}")]
pub struct StorageError {
    /// What was tried, e.g. "cannot upload".
    pub action: &'static str,
    /// Why it failed.
    pub problem: Problem,
    /// The address, or that of an object.
    pub name: String,
}

impl From<StorageError> for StoreError {
    fn from(error: StorageError) -> Self {
        Self::Store(Box::new(error))
    }
}

/// Why storage cannot be used.
#[derive(Debug, Clone, PartialEq, Eq)]
pub enum Problem {
    /// There is no such bucket.
    NoBucket,
    /// There is no such object.
    NoObject,
    /// The environment gives no credentials.
    NoCredentials(Provider),
    /// The credentials are not those of anybody.
    BadCredentials(String),
    /// The credentials are accepted, and not for this.
    NoRights(String),
    /// The bucket lies elsewhere.
    WrongRegion,
    /// No space is left, or a quota is used up.
    Full(String),
    /// Too many requests, also after a while.
    Busy(String),
    /// Nobody answers.
    Unreachable(String),
    /// Settings in the environment that cannot be.
    Settings(Provider),
    /// Files that were uploaded are not there.
    Lost(String),
    /// The disk of this machine.
    Disk(String),
    /// Anything else.
    Other(String),
}

/// What is said of anything that passes.
const GOES_ON: &str = "nothing is lost, the same command goes on";

impl fmt::Display for Problem {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::NoBucket => f.write_str("there is no such bucket: make it, or correct the address or the endpoint"),
            Self::NoObject => f.write_str("there is no such object: is this the address of a dataset?"),
            Self::NoCredentials(provider) => write!(f, "no credentials: set {}", variables(*provider)),
            Self::BadCredentials(code) => {
                write!(f, "the credentials are not accepted ({code}): correct them, {GOES_ON}")
            }
            Self::NoRights(code) => {
                write!(
                    f,
                    "the credentials do not allow that ({code}): ask for the right to list, read, write and delete, {GOES_ON}"
                )
            }
            Self::WrongRegion => f.write_str("the bucket lies in another region: set AWS_REGION to it"),
            Self::Full(code) => {
                write!(f, "the storage is full or a quota is used up ({code}): make room there, {GOES_ON}")
            }
            Self::Busy(code) => write!(f, "the server is too busy ({code}): wait, {GOES_ON}"),
            Self::Unreachable(cause) => {
                write!(f, "the server cannot be reached ({cause}): check network and endpoint, {GOES_ON}")
            }
            Self::Settings(provider) => {
                write!(f, "the settings in the environment cannot be used: check {}", variables(*provider))
            }
            Self::Lost(file) => {
                write!(
                    f,
                    "{file} was uploaded and is not there as it should be: does somebody delete there? The same command makes the video again"
                )
            }
            Self::Disk(cause) => write!(f, "{cause}: {GOES_ON}"),
            Self::Other(cause) => write!(f, "{cause}: {GOES_ON}"),
        }
    }
}

fn variables(provider: Provider) -> &'static str {
    match provider {
        Provider::S3 => "AWS_ACCESS_KEY_ID, AWS_SECRET_ACCESS_KEY, AWS_REGION, AWS_ENDPOINT_URL (docs/storage.md)",
        Provider::Google => "GOOGLE_SERVICE_ACCOUNT or GOOGLE_APPLICATION_CREDENTIALS (docs/storage.md)",
        Provider::Azure => "AZURE_STORAGE_ACCOUNT_NAME and AZURE_STORAGE_ACCOUNT_KEY (docs/storage.md)",
    }
}

impl Problem {
    /// What a library's error comes down to.
    pub(crate) fn of(error: &object_store::Error, provider: Provider) -> Self {
        // Looked through for what is known, never told.
        let said = error.to_string();
        let status = status(&said);
        let told = code(&said).or_else(|| status.clone()).unwrap_or_else(|| "no reason given".to_owned());
        let has = |words: &[&str]| words.iter().any(|word| said.contains(word));
        if has(&["169.254.169.254", "169.254.170.2", "metadata.google.internal"]) {
            return Self::NoCredentials(provider);
        }
        if has(&["NoSuchBucket", "ContainerNotFound", "The specified bucket does not exist"]) {
            return Self::NoBucket;
        }
        if has(&["QuotaExceeded", "quotaExceeded", "InsufficientStorage", "StorageFull", "XMinioStorageFull"])
            || status.as_deref() == Some("507")
        {
            return Self::Full(told);
        }
        if has(&["AuthorizationHeaderMalformed", "PermanentRedirect", "without LOCATION", "IncorrectEndpoint"]) {
            return Self::WrongRegion;
        }
        if has(&["InvalidAccessKeyId", "SignatureDoesNotMatch", "ExpiredToken", "InvalidToken", "AuthenticationFailed"])
        {
            return Self::BadCredentials(told);
        }
        // Of a listing that is refused the library does not tell the kind.
        match (error, status.as_deref()) {
            (object_store::Error::NotFound { .. }, _) | (_, Some("404")) => Self::NoObject,
            (object_store::Error::PermissionDenied { .. }, _) | (_, Some("403")) => Self::NoRights(told),
            (object_store::Error::Unauthenticated { .. }, _) | (_, Some("401")) => Self::BadCredentials(told),
            _ if has(&["SlowDown", "ServerBusy"]) => Self::Busy(told),
            (_, Some("503" | "429")) => Self::Busy(told),
            (_, None) if is_transport(error) => Self::Unreachable(innermost(error)),
            _ => Self::Other(format!("the server refuses ({told})")),
        }
    }
}

/// What stands in `<Code>` of an answer of S3 or Azure: a word.
fn code(said: &str) -> Option<String> {
    let (_, rest) = said.split_once("<Code>")?;
    let (code, _) = rest.split_once("</Code>")?;
    let plain = (1..=60).contains(&code.len()) && code.chars().all(|c| c.is_ascii_alphanumeric() || c == '.');
    plain.then(|| code.to_owned())
}

/// The status of an answer, such as `507`.
fn status(said: &str) -> Option<String> {
    let (_, rest) = said.split_once("status code: ")?;
    let number: String = rest.chars().take_while(char::is_ascii_digit).collect();
    (number.len() == 3).then_some(number)
}

fn is_transport(error: &object_store::Error) -> bool {
    causes(error).any(<dyn Error>::is::<object_store::client::HttpError>)
}

/// The last of the causes, which knows of no address: "Connection refused".
fn innermost(error: &object_store::Error) -> String {
    let cause = causes(error).last().map(ToString::to_string).unwrap_or_default();
    let plain = !cause.contains("://") && cause.len() <= 120;
    if plain { cause } else { "no answer".to_owned() }
}

fn causes(error: &object_store::Error) -> impl Iterator<Item = &(dyn Error + 'static)> {
    let first: &(dyn Error + 'static) = error;
    std::iter::successors(Some(first), |cause| (*cause).source())
}

#[cfg(test)]
mod tests {
    use super::*;

    fn answer(text: &str) -> Problem {
        let error = object_store::Error::Generic { store: "S3", source: text.into() };
        Problem::of(&error, Provider::S3)
    }

    #[test]
    fn answers_are_told_by_their_code_alone() {
        let body = |status: &str, code: &str| {
            let key = "<AWSAccessKeyId>AKIAhunter2</AWSAccessKeyId>";
            format!(
                "PUT http://u:hunter2@host/b: Server returned non-2xx status code: {status}: <Error><Code>{code}</Code>{key}</Error>"
            )
        };
        let cases = [
            ("403 Forbidden", "SignatureDoesNotMatch", Problem::BadCredentials("SignatureDoesNotMatch".into())),
            ("403 Forbidden", "QuotaExceeded", Problem::Full("QuotaExceeded".into())),
            ("404 Not Found", "NoSuchBucket", Problem::NoBucket),
            ("400 Bad Request", "AuthorizationHeaderMalformed", Problem::WrongRegion),
            ("503 Service Unavailable", "SlowDown", Problem::Busy("SlowDown".into())),
            ("507 Insufficient Storage", "hunter2 hunter2", Problem::Full("507".into())),
            ("403 Forbidden", "AccessDenied", Problem::NoRights("AccessDenied".into())),
            ("418 I'm a teapot", "", Problem::Other("the server refuses (418)".into())),
        ];
        for (status, code, wanted) in cases {
            let problem = answer(&body(status, code));
            assert_eq!(problem, wanted);
            assert!(!problem.to_string().contains("hunter2"), "{problem}");
        }
        assert_eq!(answer("GET http://169.254.169.254/latest"), Problem::NoCredentials(Provider::S3));
        assert_eq!(answer("x"), Problem::Other("the server refuses (no reason given)".into()));
    }
}
