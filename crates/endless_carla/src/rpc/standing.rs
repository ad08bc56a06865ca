//! What is answered at any time, also while a frame is made: by the thread that has read the question.
//!
//! CARLA's TrafficManager asks for the settings between two ticks and waits for the next one then. It misses that one, for ever,
//! if it begins to wait in the very moment in which the client's thread that ticks wakes it, which knows no lock there: the answer
//! must not come together with the end of a frame.

use super::answer::Answer;
use super::request::Request;
use std::collections::BTreeMap;
use std::sync::{PoisonError, RwLock};

/// Answers of methods that need nobody who thinks about them.
#[derive(Debug, Default)]
pub struct StandingAnswers {
    by_method: RwLock<BTreeMap<&'static str, Answer>>,
}

impl StandingAnswers {
    /// A method is answered like this from now on.
    pub fn set(&self, method: &'static str, answer: Answer) {
        self.by_method.write().unwrap_or_else(PoisonError::into_inner).insert(method, answer);
    }

    /// The response to a request, if it is of such a method.
    pub fn response(&self, request: &Request) -> Option<Vec<u8>> {
        let by_method = self.by_method.read().unwrap_or_else(PoisonError::into_inner);
        Some(by_method.get(request.method.as_str())?.clone().into_message(request.call_id))
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::rpc::listen;
    use std::io::{Read as _, Write as _};
    use std::net::{TcpListener, TcpStream};
    use std::sync::Arc;
    use std::sync::mpsc::sync_channel;

    #[test]
    fn they_are_given_while_nobody_takes_questions() {
        let listener = TcpListener::bind("127.0.0.1:0").unwrap();
        let address = listener.local_addr().unwrap();
        let standing = Arc::new(StandingAnswers::default());
        standing.set("version", Answer::of(&"0".to_owned()));
        standing.set("version", Answer::of(&"0.9.16".to_owned()));
        let (sender, questions) = sync_channel(8);
        std::thread::spawn(move || listen(&listener, &sender, &standing));
        let mut client = TcpStream::connect(address).unwrap();
        let ask =
            |call_id: u8, method: &[u8; 7]| [&[0x94, 0, call_id, 0xa7], &method[..], &[0x91, 0x91, 0xc2]].concat();
        client.write_all(&[ask(1, b"unasked"), ask(2, b"version")].concat()).unwrap();
        let mut answer = [0; 14];
        client.read_exact(&mut answer).unwrap();
        assert_eq!(answer[..], [&[0x94, 1, 2, 0xc0, 0x91, 0x92, 1, 0xa6][..], b"0.9.16"].concat());
        assert!(questions.try_recv().is_ok());
    }
}
