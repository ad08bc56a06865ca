//! How vehicles and walkers are driven, what they are made of, and what they report.

use super::geometry::{Location, Transform, Vector2D, Vector3D};
use super::wire_structs;

wire_structs! {
    /// Pedals, wheel and gear of a vehicle.
    VehicleControl {
        /// 0 to 1.
        throttle: f32 = 0.0,
        /// -1 to 1, to the right is positive.
        steer: f32 = 0.0,
        /// 0 to 1.
        brake: f32 = 0.0,
        /// Holds the rear wheels.
        hand_brake: bool = false,
        /// Drives backwards.
        reverse: bool = false,
        /// The gear is [`Self::gear`], whatever the speed.
        manual_gear_shift: bool = false,
        /// -1 backwards, 0 neutral, from 1 on forwards.
        gear: i32 = 0,
    }
    /// What a vehicle shall do, for a controller to find the pedals.
    VehicleAckermannControl {
        /// Angle of the front wheels, radians, to the right is positive.
        steer: f32 = 0.0,
        /// How fast that angle changes, rad/s; 0 for at once.
        steer_speed: f32 = 0.0,
        /// m/s, backwards is negative.
        speed: f32 = 0.0,
        /// How fast the speed changes, m/s²; 0 for what is usual.
        acceleration: f32 = 0.0,
        /// m/s³; CARLA has no use for it.
        jerk: f32 = 0.0,
    }
    /// Gains of the controller behind [`VehicleAckermannControl`].
    AckermannControllerSettings {
        /// Proportional, of speed.
        speed_kp: f32 = 0.0,
        /// Integral, of speed.
        speed_ki: f32 = 0.0,
        /// Derivative, of speed.
        speed_kd: f32 = 0.0,
        /// Proportional, of acceleration.
        accel_kp: f32 = 0.0,
        /// Integral, of acceleration.
        accel_ki: f32 = 0.0,
        /// Derivative, of acceleration.
        accel_kd: f32 = 0.0,
    }
    /// Where a walker goes.
    WalkerControl {
        /// In the world.
        direction: Vector3D = Vector3D { x: 1.0, y: 0.0, z: 0.0 },
        /// m/s.
        speed: f32 = 0.0,
        /// Jumps, if it stands.
        jump: bool = false,
    }
    /// A gear.
    GearPhysicsControl {
        /// Turns of the engine for one of the shaft.
        ratio: f32 = 1.0,
        /// Shifts down below this share of the highest engine speed.
        down_ratio: f32 = 0.5,
        /// Shifts up above this share of the highest engine speed.
        up_ratio: f32 = 0.65,
    }
    /// A wheel.
    WheelPhysicsControl {
        /// How well it grips: 0 not at all, about 3.5 on dry roads.
        tire_friction: f32 = 2.0,
        /// kg m²/s.
        damping_rate: f32 = 0.25,
        /// Degrees.
        max_steer_angle: f32 = 70.0,
        /// Centimetres.
        radius: f32 = 30.0,
        /// N m.
        max_brake_torque: f32 = 1500.0,
        /// N m.
        max_handbrake_torque: f32 = 3000.0,
        /// Load (as a share of that at rest) above which it becomes no stiffer.
        lat_stiff_max_load: f32 = 2.0,
        /// Stiffness to the side.
        lat_stiff_value: f32 = 17.0,
        /// Stiffness along.
        long_stiff_value: f32 = 1000.0,
        /// In the world, centimetres; only told, never set.
        position: Vector3D = Vector3D::default(),
    }
    /// What a vehicle is made of.
    VehiclePhysicsControl {
        /// N m over rpm.
        torque_curve: Vec<Vector2D> = vec![Vector2D { x: 0.0, y: 500.0 }, Vector2D { x: 5000.0, y: 500.0 }],
        /// Highest engine speed.
        max_rpm: f32 = 5000.0,
        /// Of the engine, kg m².
        moi: f32 = 1.0,
        /// Of the engine at full throttle, kg m²/s.
        damping_rate_full_throttle: f32 = 0.15,
        /// Of the engine without throttle, in gear, kg m²/s.
        damping_rate_zero_throttle_clutch_engaged: f32 = 2.0,
        /// Of the engine without throttle, in neutral, kg m²/s.
        damping_rate_zero_throttle_clutch_disengaged: f32 = 0.35,
        /// Shifts by itself.
        use_gear_autobox: bool = true,
        /// Seconds.
        gear_switch_time: f32 = 0.5,
        /// kg m²/s.
        clutch_strength: f32 = 10.0,
        /// Turns of the shaft for one of the wheels.
        final_ratio: f32 = 4.0,
        /// From the first on.
        forward_gears: Vec<GearPhysicsControl> = Vec::new(),
        /// Kilograms.
        mass: f32 = 1000.0,
        /// Of air.
        drag_coefficient: f32 = 0.3,
        /// From where it is by itself, metres.
        center_of_mass: Location = Location::default(),
        /// Share of the steering angle over speed in km/h.
        steering_curve: Vec<Vector2D> = vec![Vector2D { x: 0.0, y: 1.0 }, Vector2D { x: 10.0, y: 0.5 }],
        /// Front left, front right, rear left, rear right.
        wheels: Vec<WheelPhysicsControl> = Vec::new(),
        /// Wheels meet the ground with their whole shape.
        use_sweep_wheel_collision: bool = false,
    }
    /// What a wheel does.
    WheelTelemetryData {
        /// As in [`WheelPhysicsControl`].
        tire_friction: f32 = 0.0,
        /// Angle between where it points and where it goes, radians.
        lat_slip: f32 = 0.0,
        /// How much faster its rim is than the ground, as a share.
        long_slip: f32 = 0.0,
        /// rad/s.
        omega: f32 = 0.0,
        /// Newtons.
        tire_load: f32 = 0.0,
        /// As a share of that at rest.
        normalized_tire_load: f32 = 0.0,
        /// N m.
        torque: f32 = 0.0,
        /// Newtons.
        long_force: f32 = 0.0,
        /// Newtons.
        lat_force: f32 = 0.0,
        /// As a share of the load.
        normalized_long_force: f32 = 0.0,
        /// As a share of the load.
        normalized_lat_force: f32 = 0.0,
    }
    /// What a vehicle does, since 0.9.16.
    VehicleTelemetryData {
        /// Forwards, m/s.
        speed: f32 = 0.0,
        /// As driven.
        steer: f32 = 0.0,
        /// As driven.
        throttle: f32 = 0.0,
        /// As driven.
        brake: f32 = 0.0,
        /// Turns of the engine a minute.
        engine_rpm: f32 = 0.0,
        /// As in [`VehicleControl`].
        gear: i32 = 0,
        /// Force of the air, newtons.
        drag: f32 = 0.0,
        /// In the order of [`VehiclePhysicsControl::wheels`].
        wheels: Vec<WheelTelemetryData> = Vec::new(),
    }
    /// Where a bone is.
    BoneTransform {
        /// Its name.
        name: String = String::new(),
        /// In the world.
        world: Transform = Transform::default(),
        /// In the walker.
        component: Transform = Transform::default(),
        /// To the bone that it hangs on.
        relative: Transform = Transform::default(),
    }
    /// Where a walker's bones are.
    WalkerBones {
        /// All of them.
        bones: Vec<BoneTransform> = Vec::new(),
    }
    /// Where a walker's bones shall be, each to the one that it hangs on.
    WalkerBonesControl {
        /// Those that are told.
        bones: Vec<(String, Transform)> = Vec::new(),
    }
}
