//! A TrafficManager that runs somewhere: in the process of CARLA's own client. It speaks msgpack-rpc as the server does, but
//! without metadata and wrappers.

use super::address::Address;
use super::connection::Connection;
use super::error::ClientError;
use super::patience::StopFlag;
use crate::wire::{Actor, Wire};
use rmpv::Value;
use std::time::Duration;

/// How long a step of it may take.
const STEP: Duration = Duration::from_secs(30);

/// A connection to a TrafficManager.
pub(super) struct TrafficManager {
    connection: Connection,
    registered: Vec<Actor>,
}

impl TrafficManager {
    /// Takes over vehicles: it drives them, and their lights, a step a frame.
    pub(super) fn drive(
        address: &Address,
        vehicles: Vec<Actor>,
        seed: u64,
        stop: &StopFlag,
    ) -> Result<Self, ClientError> {
        let refused = |error| match error {
            ClientError::Refused(error) => ClientError::Unusable(format!(
                "no TrafficManager listens at {address} ({error}): leave out --traffic-manager"
            )),
            other => other,
        };
        let mut connection = Connection::new(&address.host, address.port, stop).map_err(refused)?;
        connection.plain("set_synchronous_mode", vec![true.into()], STEP)?;
        connection.plain("set_random_device_seed", vec![seed.into()], STEP)?;
        connection.plain("register_vehicle", vec![vehicles.to_value()], STEP)?;
        for vehicle in &vehicles {
            connection.plain("update_vehicle_lights", vec![vehicle.to_value(), true.into()], STEP)?;
        }
        Ok(Self { connection, registered: vehicles })
    }

    /// Decides what all do until the next frame.
    pub(super) fn step(&mut self) -> Result<(), ClientError> {
        match self.connection.plain("synchronous_tick", vec![], STEP)? {
            Value::Boolean(false) => Err(ClientError::Unfit("the TrafficManager did not step".to_owned())),
            _ => Ok(()),
        }
    }

    /// Lets go of all vehicles; whoever else uses it goes on.
    pub(super) fn leave(&mut self) -> Result<(), ClientError> {
        let vehicles = std::mem::take(&mut self.registered);
        self.connection.plain("unregister_vehicle", vec![vehicles.to_value()], STEP)?;
        self.connection.plain("set_synchronous_mode", vec![false.into()], STEP).map(drop)
    }
}
