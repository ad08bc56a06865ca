//! `tf.train.Example` (`tensorflow/core/example/{example,feature}.proto`).

use prost::Message;
use std::collections::BTreeMap;

/// Values of one key.
#[derive(Debug, Clone, PartialEq)]
pub(super) enum Feature {
    Bytes(Vec<Vec<u8>>),
    Floats(Vec<f32>),
    Whole(Vec<i64>),
}

#[derive(Clone, PartialEq, Message)]
struct BytesList {
    #[prost(bytes = "vec", repeated, tag = "1")]
    value: Vec<Vec<u8>>,
}

#[derive(Clone, PartialEq, Message)]
struct FloatList {
    #[prost(float, repeated, tag = "1")]
    value: Vec<f32>,
}

#[derive(Clone, PartialEq, Message)]
struct Int64List {
    #[prost(int64, repeated, tag = "1")]
    value: Vec<i64>,
}

#[derive(Clone, PartialEq, prost::Oneof)]
enum Kind {
    #[prost(message, tag = "1")]
    Bytes(BytesList),
    #[prost(message, tag = "2")]
    Float(FloatList),
    #[prost(message, tag = "3")]
    Int64(Int64List),
}

#[derive(Clone, PartialEq, Message)]
struct FeatureMessage {
    #[prost(oneof = "Kind", tags = "1, 2, 3")]
    kind: Option<Kind>,
}

#[derive(Clone, PartialEq, Message)]
struct Features {
    #[prost(btree_map = "string, message", tag = "1")]
    feature: BTreeMap<String, FeatureMessage>,
}

#[derive(Clone, PartialEq, Message)]
struct Example {
    #[prost(message, optional, tag = "1")]
    features: Option<Features>,
}

/// The bytes of an example; keys are sorted, so that they are the same each time.
pub(super) fn encode(features: &BTreeMap<String, Feature>) -> Vec<u8> {
    let message = |feature: &Feature| {
        let kind = match feature.clone() {
            Feature::Bytes(value) => Kind::Bytes(BytesList { value }),
            Feature::Floats(value) => Kind::Float(FloatList { value }),
            Feature::Whole(value) => Kind::Int64(Int64List { value }),
        };
        FeatureMessage { kind: Some(kind) }
    };
    let feature = features.iter().map(|(key, feature)| (key.clone(), message(feature))).collect();
    Example { features: Some(Features { feature }) }.encode_to_vec()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn an_example_has_the_bytes_of_its_protocol() {
        let features = BTreeMap::from([("a".to_owned(), Feature::Whole(vec![1, 300]))]);
        // Example.features { feature { key "a", value { int64_list { value [1, 300] packed } } } }
        let expected = [10, 14, 10, 12, 10, 1, b'a', 18, 7, 26, 5, 10, 3, 1, 0xac, 2];
        assert_eq!(encode(&features), expected);
    }
}
