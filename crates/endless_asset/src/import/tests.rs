//! Files made here: what is read of them, and that nothing that can be in a file makes trouble.

use super::{AssetEntry, AssetManifest, ImportError, ImportedAsset};
use crate::{Prop, VehicleModel};
use endless_scene::{LightSlot, Mesh, Surface};
use endless_world::{ClassTag, ObjectClass};
use glam::Vec3;
use proptest::prelude::*;
use serde_json::{Value, json};

/// A file from its document and its buffer.
fn glb(document: &Value, buffer: &[u8]) -> Vec<u8> {
    let mut text = document.to_string().into_bytes();
    text.resize(text.len().next_multiple_of(4), b' ');
    let whole = 12 + 8 + text.len() + 8 + buffer.len();
    let word = |n: usize| (n as u32).to_le_bytes();
    let parts: [&[u8]; 9] =
        [b"glTF", &word(2), &word(whole), &word(text.len()), b"JSON", &text, &word(buffer.len()), b"BIN\0", buffer];
    parts.concat()
}

/// A box of 1 m about the origin: 24 vertices with normals and surface coordinates.
fn cube() -> (Vec<u8>, Value) {
    let mut vertices = (vec![], vec![], vec![]);
    let mut indices: Vec<u32> = Vec::new();
    for (axis, side) in (0..3).flat_map(|a| [(a, 1.0f32), (a, -1.0)]) {
        let normal = Vec3::AXES[axis] * side;
        let (u, v) = (Vec3::AXES[(axis + 1) % 3], Vec3::AXES[(axis + 2) % 3] * side);
        let base = vertices.0.len() as u32;
        for (a, b) in [(-0.5, -0.5), (0.5, -0.5), (0.5, 0.5), (-0.5, 0.5)] {
            vertices.0.push(normal * 0.5 + u * a + v * b);
            vertices.1.push(normal);
            vertices.2.push([a + 0.5, b + 0.5]);
        }
        indices.extend([0, 1, 2, 0, 2, 3].map(|k| base + k));
    }
    let mut buffer: Vec<u8> = Vec::new();
    let floats = |buffer: &mut Vec<u8>, f: &[f32]| f.iter().for_each(|x| buffer.extend(x.to_le_bytes()));
    vertices.0.iter().for_each(|p| floats(&mut buffer, &p.to_array()));
    vertices.1.iter().for_each(|p| floats(&mut buffer, &p.to_array()));
    vertices.2.iter().for_each(|p| floats(&mut buffer, p));
    indices.iter().for_each(|i| buffer.extend(i.to_le_bytes()));
    let document = json!({
        "asset": { "version": "2.0" },
        "scene": 0,
        "scenes": [{ "nodes": [0] }],
        "nodes": [
            { "name": "car", "children": [1, 2, 3, 4, 5] },
            // glTF: x to the left, y up, z ahead.
            { "name": "body", "mesh": 0, "scale": [1.8, 1.2, 4.0], "translation": [0.0, 0.9, 0.0] },
            { "name": "Wheel FL", "mesh": 1, "scale": [0.2, 0.6, 0.6], "translation": [0.75, 0.3, 1.3] },
            { "name": "Wheel FR", "mesh": 1, "scale": [-0.2, 0.6, 0.6], "translation": [-0.75, 0.3, 1.3] },
            { "name": "Wheel RL", "mesh": 1, "scale": [0.2, 0.6, 0.6], "translation": [0.75, 0.3, -1.2] },
            { "name": "Wheel RR", "mesh": 1, "scale": [-0.2, 0.6, 0.6], "translation": [-0.75, 0.3, -1.2] },
        ],
        "meshes": [
            { "primitives": [{ "attributes": { "POSITION": 0, "NORMAL": 1, "TEXCOORD_0": 2 }, "indices": 3, "material": 0 }] },
            { "primitives": [{ "attributes": { "POSITION": 0, "NORMAL": 1, "TEXCOORD_0": 2 }, "indices": 3, "material": 1 }] },
        ],
        "materials": [
            { "name": "Body", "pbrMetallicRoughness": { "baseColorFactor": [0.2, 0.1, 0.05, 1.0], "metallicFactor": 0.0 } },
            { "name": "Tyre", "pbrMetallicRoughness": { "baseColorFactor": [0.02, 0.02, 0.02, 1.0] } },
        ],
        "buffers": [{ "byteLength": buffer.len() }],
        "bufferViews": [
            { "buffer": 0, "byteOffset": 0, "byteLength": 288 },
            { "buffer": 0, "byteOffset": 288, "byteLength": 288 },
            { "buffer": 0, "byteOffset": 576, "byteLength": 192 },
            { "buffer": 0, "byteOffset": 768, "byteLength": 144 },
        ],
        "accessors": [
            { "bufferView": 0, "componentType": 5126, "count": 24, "type": "VEC3", "min": [-0.5, -0.5, -0.5], "max": [0.5, 0.5, 0.5] },
            { "bufferView": 1, "componentType": 5126, "count": 24, "type": "VEC3" },
            { "bufferView": 2, "componentType": 5126, "count": 24, "type": "VEC2" },
            { "bufferView": 3, "componentType": 5125, "count": 36, "type": "SCALAR" },
        ],
    });
    (buffer, document)
}

fn entry(text: &str) -> AssetEntry {
    let manifest = AssetManifest::parse(&format!("[[asset]]\nfile = \"a.glb\"\n{text}")).expect("a manifest");
    manifest.assets.into_iter().next().expect("an entry")
}

const CAR: &str = "class = 'car'\nsize = [4.4, 1.98, 1.65]\n";

fn vehicle(text: &str, document: &Value, buffer: &[u8]) -> VehicleModel {
    match entry(text).import(&glb(document, buffer), &|_| None) {
        Ok(ImportedAsset::Vehicle(vehicle)) => vehicle,
        other => panic!("{other:?}"),
    }
}

fn refused(text: &str, document: &Value, buffer: &[u8]) -> String {
    let error = entry(text).import(&glb(document, buffer), &|_| None).expect_err("to be refused").to_string();
    assert_eq!(error.lines().count(), 1, "{error}");
    error
}

fn area(mesh: &Mesh, is: impl Fn(&endless_scene::Material) -> bool) -> f32 {
    let of = |(t, &m): (&[u32; 3], &u16)| {
        let [a, b, c] = t.map(|i| mesh.positions[i as usize]);
        if is(&mesh.materials[usize::from(m)]) { 0.5 * (b - a).cross(c - a).length() } else { 0.0 }
    };
    mesh.triangles.iter().zip(&mesh.triangle_materials).map(of).sum()
}

#[test]
fn a_vehicle_has_its_real_size_its_wheels_and_its_axles() {
    let (buffer, document) = cube();
    let car = vehicle(CAR, &document, &buffer);
    assert_eq!((car.name(), car.spec.class), ("imported.a", ObjectClass::Car));
    let (low, high) = car.whole().bounds();
    let size = high - low;
    assert!((size - Vec3::new(4.4, 1.98, 1.65)).abs().max_element() < 1e-4, "{size}");
    assert!((size.x - car.spec.length_m).abs() < 1e-5 && (size.z - car.spec.height_m).abs() < 1e-5);
    assert!(low.z.abs() < 1e-5 && (low.x + high.x).abs() < 1e-5);
    assert_eq!(car.wheels().len(), 4);
    assert_eq!(car.wheels().iter().filter(|w| w.steered).count(), 2);
    for wheel in car.wheels() {
        assert_eq!(wheel.mirrored, wheel.position.y < 0.0);
        assert_eq!(wheel.steered, wheel.position.x > 0.0);
        assert!((wheel.position.z - 0.33).abs() < 1e-4);
    }
    assert!((car.spec.front_axle_m - 1.43).abs() < 1e-4 && (car.spec.rear_axle_m + 1.32).abs() < 1e-4);
    assert!((car.spec.wheel_radius_m - 0.33).abs() < 1e-4);
    assert_eq!(car.tint(7), [1.0; 3], "as in the file");
    let volume: f32 = car
        .whole()
        .triangles
        .iter()
        .map(|t| {
            let [a, b, c] = t.map(|i| car.whole().positions[i as usize]);
            a.dot(b.cross(c)) / 6.0
        })
        .sum();
    assert!(volume > 11.0, "wound outwards, wheels mirrored or not: {volume} m³");
}

#[test]
fn paint_and_lamps_are_what_the_entry_says() {
    let (buffer, document) = cube();
    let text = format!(
        "{CAR}paint = ['Body']\nlights = {{ head = [[2.2, 0.6, 0.8], [2.2, -0.6, 0.8]], tail = [[-2.2, 0.6, 0.9]], brake = \
         ['Tyre'] }}"
    );
    let car = vehicle(&text, &document, &buffer);
    assert!((0..20).map(|v| car.tint(v)).any(|t| t != car.tint(0)), "painted as on real roads");
    assert!(car.body().materials.iter().any(|m| m.surface == Surface::CarPaint && m.base_color == [1.0; 3]));
    assert!(car.wheel_mesh().materials.iter().all(|m| m.surface == Surface::VehicleLight(LightSlot::Brake)));
    let [left, right] = car.headlights() else { panic!("{:?}", car.headlights()) };
    assert!((*left - Vec3::new(2.2, 0.6, 0.8)).length() < 0.01 && (right.y + 0.6).abs() < 0.01);
    let disc = area(car.body(), |m| m.surface == Surface::VehicleLight(LightSlot::Head));
    assert!((disc - 2.0 * 0.0091).abs() < 0.001, "{disc}");
    let (low, high) = car.whole().bounds();
    assert!((high.x - low.x - car.spec.length_m).abs() < 1e-5, "lenses are counted");

    let off = format!("{CAR}lights = {{ head = [[5.0, 0.6, 0.8]] }}");
    assert!(refused(&off, &document, &buffer).contains("not on the vehicle"));
    let unknown = format!("{CAR}paint = ['Bodi']");
    assert!(refused(&unknown, &document, &buffer).contains("it has Body, Tyre"));
}

#[test]
fn pictures_become_colours_where_they_are() {
    // Left half red, right half green.
    let mut picture = Vec::new();
    {
        let mut encoder = png::Encoder::new(&mut picture, 2, 1);
        encoder.set_color(png::ColorType::Rgb);
        let mut writer = encoder.write_header().expect("writable");
        writer.write_image_data(&[200, 10, 10, 10, 200, 10]).expect("writable");
    }
    let (mut buffer, mut document) = cube();
    let at = buffer.len();
    buffer.extend(&picture);
    document["buffers"][0]["byteLength"] = json!(buffer.len());
    let view = json!({ "buffer": 0, "byteOffset": at, "byteLength": picture.len() });
    document["bufferViews"].as_array_mut().expect("a list").push(view);
    document["images"] = json!([{ "bufferView": 4, "mimeType": "image/png" }]);
    document["textures"] = json!([{ "source": 0 }]);
    document["materials"][0]["pbrMetallicRoughness"] =
        json!({ "baseColorTexture": { "index": 0 }, "metallicFactor": 0.0 });
    let car = vehicle(CAR, &document, &buffer);
    let body = car.body();
    let all = area(body, |_| true);
    let red = area(body, |m| m.base_color[0] > 0.45 && m.base_color[1] < 0.02);
    let green = area(body, |m| m.base_color[1] > 0.45 && m.base_color[0] < 0.02);
    assert!((red / all - 0.5).abs() < 0.03 && (green / all - 0.5).abs() < 0.03, "{red} {green} {all}");
    assert!((area(body, |_| true) - 2.0 * 1.21 * (4.0 * 1.8 + 4.0 * 1.2 + 1.8 * 1.2)).abs() < 0.01);

    document["images"] = json!([{ "uri": "maps/the%20body.png" }]);
    let read_external = |path: &str| (path == "maps/the body.png").then(|| picture.clone());
    let made = entry(CAR).import(&glb(&document, &buffer), &read_external).expect("a picture beside it");
    let ImportedAsset::Vehicle(same) = made else { panic!("{made:?}") };
    assert_eq!(same.body(), body);
    document["images"] = json!([{ "uri": "body.png" }]);
    assert!(refused(CAR, &document, &buffer).contains("body.png"));
    document["images"] = json!([{ "bufferView": 0, "mimeType": "image/png" }]);
    assert!(refused(CAR, &document, &buffer).contains("image 0"));
}

#[test]
fn things_stand_on_the_ground_and_look_ahead() {
    let (buffer, document) = cube();
    let text = "class = 'kiosk'\nforward = '-z'\nsize = [2.0, 0.9, 0.75]\nshare = 1.0";
    let made = entry(text).import(&glb(&document, &buffer), &|_| None).expect("a kiosk");
    let ImportedAsset::StaticModel(kiosk) = made else { panic!("{made:?}") };
    assert_eq!(kiosk.prop, Some(Prop::Kiosk));
    let (low, high) = kiosk.mesh.bounds();
    assert!((high - low - Vec3::new(2.0, 0.9, 0.75)).abs().max_element() < 1e-4 && low.z.abs() < 1e-6);
    // What was behind is ahead.
    assert!((0.5 * (low + high)).truncate().length() < 1e-5);
    let made = entry("class = 'building'\nsize = [20.0, 9.0, 7.5]")
        .import(&glb(&document, &buffer), &|_| None)
        .expect("a building");
    let ImportedAsset::StaticModel(building) = made else { panic!("{made:?}") };
    assert!(building.mesh.materials.iter().all(|m| m.tag == ClassTag::Buildings));
}

#[test]
fn broken_files_are_told_apart() {
    let (buffer, document) = cube();
    let whole = glb(&document, &buffer);
    let extra = |bytes: &[u8]| entry(CAR).import(bytes, &|_| None).expect_err("broken").to_string();
    assert!(extra(b"").contains("not a binary glTF"));
    assert!(extra(b"solid cube\n").contains("not a binary glTF"));
    assert!(extra(&whole[..7]).contains("cut off"));
    assert!(extra(&whole[..200]).contains("cut off"));
    assert!(extra(&whole[..whole.len() - 1]).contains("cut off"));
    let mut old = whole.clone();
    old[4] = 1;
    assert!(extra(&old).contains("version 1"));
    let mut garbled = whole.clone();
    garbled[30] = b'{';
    assert!(extra(&garbled).contains("damaged"));

    let with = |path: &str, value: Value| {
        let mut changed = document.clone();
        *changed.pointer_mut(path).expect("a place") = value;
        refused(CAR, &changed, &buffer)
    };
    assert!(with("/accessors/3/count", json!(3600)).contains("beyond the buffer"));
    assert!(with("/accessors/0/count", json!(u64::MAX)).contains("damaged"));
    assert!(with("/bufferViews/0/byteOffset", json!(1_000_000)).contains("beyond the buffer"));
    assert!(with("/meshes/0/primitives/0/material", json!(9)).contains("not there"));
    assert!(with("/buffers/0", json!({ "byteLength": 912, "uri": "car.bin" })).contains("car.bin"));
    assert!(with("/buffers/0", json!({ "byteLength": 9120 })).contains("9120"));
    let mut knotted = document.clone();
    knotted["nodes"][1]["children"] = json!([0]);
    assert!(refused(CAR, &knotted, &buffer).contains("within itself"));
    // Each node twice below the one before: without end.
    let chain: Vec<Value> = (1..50).map(|k| json!({ "children": [k, k] })).chain([json!({ "mesh": 0 })]).collect();
    knotted["nodes"] = json!(chain);
    assert!(refused(CAR, &knotted, &buffer).contains("nodes"));
    assert!(with("/nodes/1/scale", json!([1e38, 1e38, 1e38])).contains("not a number"));
    assert!(with("/scenes/0/nodes", json!([])).contains("no triangles"));
    let mut compressed = document.clone();
    compressed["extensionsRequired"] = json!(["KHR_draco_mesh_compression"]);
    assert!(refused(CAR, &compressed, &buffer).contains("KHR_draco_mesh_compression"));

    let mut no_number = buffer.clone();
    no_number[0..4].copy_from_slice(&f32::NAN.to_le_bytes());
    assert!(refused(CAR, &document, &no_number).contains("vertex 0"));
    let mut doubled = document.clone();
    let again = doubled["nodes"][0]["children"].clone();
    doubled["nodes"][0]["children"] = json!([1, 1, 2, 2, 3, 3, 4, 4, 5, 5]);
    assert_ne!(again, doubled["nodes"][0]["children"]);
    assert!(refused(CAR, &doubled, &buffer).contains("more than two faces"));
    let many: Vec<u32> = std::iter::repeat_n(1, 190_000).collect();
    doubled["nodes"][0]["children"] = json!(many);
    assert!(refused(CAR, &doubled, &buffer).contains("simplify"));
}

#[test]
fn entries_that_cannot_be_are_refused_before_the_file_is_read() {
    let extra = |text: &str| entry(text).check().expect_err("refused").to_string();
    assert!(extra("class = 'boat'\nsize = [4.4, 2.0, 1.6]").contains("class = boat"));
    assert!(extra("class = 'signal_pole'\nsize = [1.0, 1.0, 1.0]").contains("no signals"));
    assert!(extra("class = 'car'\nsize = [44.0, 2.0, 1.6]").contains("at most 30"));
    assert!(extra("class = 'car'\nsize = [nan, 2.0, 1.6]").contains("metres"));
    assert!(extra("class = 'car'\nsize = [4.4, 2.0, 1.6]\naxles = [-1.0, 1.0]").contains("front and the rear"));
    assert!(extra("class = 'motorcycle'\nsize = [2.1, 0.8, 1.2]").contains("seat"));
    assert!(extra("class = 'car'\nsize = [4.4, 2.0, 1.6]\nfrequency = -1.0").contains("frequency"));
    assert!(extra("class = 'bench'\nsize = [0.6, 1.8, 0.9]\nshare = 2.0").contains("share"));
    let outside = AssetEntry { file: "../a.glb".to_owned(), ..entry(CAR) };
    assert!(outside.check().expect_err("refused").to_string().contains("file = ../a.glb"));
    let odd = AssetEntry { name: Some("a\nb".to_owned()), ..entry(CAR) };
    assert!(odd.check().is_err());
    let error = AssetManifest::parse("[[asset]]\nfile = 'a.glb'\nclas = 'car'\n").expect_err("misspelt");
    assert!(matches!(error, ImportError::Manifest { line: 3, column: 1, .. }), "{error}");

    let (buffer, document) = cube();
    assert!(refused("class = 'car'\nsize = [4.4, 1.2, 1.65]", &document, &buffer).contains("1.98 m wide"));
    assert!(refused("class = 'car'\nsize = [4.4, 1.98, 2.6]", &document, &buffer).contains("1.65 m high"));
    let unnamed = format!("{CAR}wheels = 'roue'");
    assert!(refused(&unnamed, &document, &buffer).contains("'roue'"));
    let stated =
        vehicle(&format!("{CAR}wheels = 'roue'\naxles = [1.4, -1.3]\nwheel_radius = 0.33"), &document, &buffer);
    assert!(stated.wheels().is_empty() && stated.spec.front_axle_m == 1.4);
}

/// Numbers that documents can be made wrong with.
fn number() -> impl Strategy<Value = Value> {
    prop_oneof![
        (0u64..40).prop_map(|n| json!(n)),
        Just(json!(u64::MAX)),
        Just(json!(u32::MAX)),
        Just(json!(-1)),
        Just(json!(1e300)),
        (-1e6..1e6f64).prop_map(|n| json!(n)),
        Just(json!("text")),
        Just(Value::Null),
    ]
}

/// Puts a value where the n-th number of a document is.
fn replace_number(document: &mut Value, n: &mut usize, value: &Value) {
    match document {
        Value::Number(_) => {
            if *n == 0 {
                *document = value.clone();
            }
            *n = n.wrapping_sub(1);
        }
        Value::Array(items) => items.iter_mut().for_each(|item| replace_number(item, n, value)),
        Value::Object(map) => map.values_mut().for_each(|item| replace_number(item, n, value)),
        _ => {}
    }
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(600))]

    #[test]
    fn bytes_changed_at_random_never_panic(
        changes in prop::collection::vec((0usize..4000, any::<u8>()), 1..12), cut in 0usize..4000,
    ) {
        let (buffer, document) = cube();
        let mut bytes = glb(&document, &buffer);
        for (at, byte) in changes {
            let at = at % bytes.len();
            bytes[at] = byte;
        }
        let _ = entry(CAR).import(&bytes, &|_| None);
        bytes.truncate(cut);
        let _ = entry(CAR).import(&bytes, &|_| None);
    }

    #[test]
    fn documents_with_wrong_numbers_never_panic(changes in prop::collection::vec((0usize..140, number()), 1..4)) {
        let (buffer, mut document) = cube();
        for (n, value) in changes {
            replace_number(&mut document, &mut n.clone(), &value);
        }
        if let Ok(ImportedAsset::Vehicle(car)) = entry(CAR).import(&glb(&document, &buffer), &|_| None) {
            let whole = car.whole();
            prop_assert!(whole.positions.iter().all(|p| p.is_finite()));
            prop_assert!(whole.normals.iter().all(|n| (n.length() - 1.0).abs() < 1e-3));
            prop_assert!(whole.triangles.iter().flatten().all(|&i| (i as usize) < whole.positions.len()));
        }
    }

    #[test]
    fn buffers_of_any_floats_never_panic(words in prop::collection::vec(any::<u32>(), 228)) {
        let (_, document) = cube();
        let buffer: Vec<u8> = words.iter().flat_map(|w| w.to_le_bytes()).collect();
        let _ = entry(CAR).import(&glb(&document, &buffer), &|_| None);
    }

    #[test]
    fn manifests_of_any_text_never_panic(text in "\\PC{0,200}") {
        let _ = AssetManifest::parse(&text);
        let _ = AssetManifest::parse(&format!("[[asset]]\nfile = \"a.glb\"\nclass = \"{text}"));
    }
}
