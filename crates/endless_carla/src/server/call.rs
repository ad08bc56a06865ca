//! Methods.

use super::call_error::CallError;
use super::world::World;
use crate::rpc::{Answer, Caller, Request};

/// What a method gives back, or why it fails.
pub(super) type CallResult = Result<Answer, CallError>;

/// A method of the protocol.
pub(super) type Method = fn(&mut World, &Call<'_>) -> CallResult;

/// The method of what is accepted and has no effect.
pub(super) fn nothing_to_do(_: &mut World, _: &Call<'_>) -> CallResult {
    Ok(Answer::Void)
}

/// A request, and who made it.
pub(super) struct Call<'a> {
    pub(super) caller: &'a Caller,
    pub(super) request: &'a Request,
}
