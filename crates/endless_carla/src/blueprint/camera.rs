//! Attributes of cameras.

use super::attribute::{float, floats, int, restricted, sensor_tick, switch};
use super::sensor::SensorKind;
use crate::wire::{ActorAttribute, AttributeType};

/// Those of a camera of this kind.
pub(super) fn attributes(kind: SensorKind) -> Vec<ActorAttribute> {
    let mut attributes =
        vec![sensor_tick(), int("image_size_x", "800"), int("image_size_y", "600"), float("fov", "90.0")];
    attributes.extend(lens());
    if matches!(kind, SensorKind::Rgb | SensorKind::Dvs) {
        attributes.extend(exposure());
        attributes.extend(effects());
        attributes.extend(film());
    }
    if kind == SensorKind::Dvs {
        attributes.extend(events());
    }
    attributes
}

/// Distortion and the dark rim.
fn lens() -> Vec<ActorAttribute> {
    vec![
        float("lens_circle_falloff", "5.0"),
        float("lens_circle_multiplier", "0.0"),
        float("lens_k", "-1.0"),
        float("lens_kcube", "0.0"),
        float("lens_x_size", "0.08"),
        float("lens_y_size", "0.08"),
    ]
}

/// How much light becomes which brightness.
fn exposure() -> Vec<ActorAttribute> {
    vec![
        restricted("exposure_mode", AttributeType::String, &["histogram", "manual"]),
        // Of CARLA on Linux; 0 on Windows.
        float("exposure_compensation", "0.75"),
        float("shutter_speed", "200.0"),
        float("iso", "100.0"),
        float("fstop", "1.4"),
        float("exposure_min_bright", "10.0"),
        float("exposure_max_bright", "12.0"),
        float("exposure_speed_up", "3.0"),
        float("exposure_speed_down", "1.0"),
        float("calibration_constant", "16.0"),
    ]
}

/// What a game's camera does to a picture.
fn effects() -> Vec<ActorAttribute> {
    vec![
        switch("enable_postprocess_effects", true),
        float("gamma", "2.2"),
        float("motion_blur_intensity", "0.45"),
        float("motion_blur_max_distortion", "0.35"),
        float("motion_blur_min_object_screen_size", "0.1"),
        float("lens_flare_intensity", "0.1"),
        float("bloom_intensity", "0.675"),
        // Centimetres.
        float("focal_distance", "1000.0"),
        float("min_fstop", "1.2"),
        int("blade_count", "5"),
        float("blur_amount", "1.0"),
        float("blur_radius", "0.0"),
        float("chromatic_aberration_intensity", "0.0"),
        float("chromatic_aberration_offset", "0.0"),
    ]
}

/// Tone curve and white balance.
fn film() -> Vec<ActorAttribute> {
    vec![
        float("slope", "0.88"),
        float("toe", "0.55"),
        float("shoulder", "0.26"),
        float("black_clip", "0.0"),
        float("white_clip", "0.04"),
        // Kelvins.
        float("temp", "6500.0"),
        float("tint", "0.0"),
    ]
}

/// When a change of brightness is an event.
fn events() -> Vec<ActorAttribute> {
    let mut events: Vec<ActorAttribute> = floats(&["positive_threshold", "negative_threshold"], "0.3").collect();
    events.extend(floats(&["sigma_positive_threshold", "sigma_negative_threshold"], "0.0"));
    events.push(int("refractory_period_ns", "0"));
    events.push(switch("use_log", true));
    events.push(float("log_eps", "0.001"));
    events
}
