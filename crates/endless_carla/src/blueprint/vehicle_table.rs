//! CARLA's vehicles: facts of its public catalogue, and boxes as its clients see them.

use endless_world::ObjectClass::{self, Bicycle, Bus, Car, Motorcycle, Truck, Van};

/// What can be switched and opened.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(super) enum Equipment {
    Plain,
    Lights,
    /// And lights.
    Doors,
}
use Equipment::{Doors, Lights, Plain};

/// Id, base type, special type, generation, equipment, about its mass (kg), half of CARLA's box and where its middle is
/// (metres: forward, right, up).
pub(super) type Row = (&'static str, ObjectClass, &'static str, u8, Equipment, f32, [f32; 3], [f32; 3]);

/// In the order of their ids.
#[rustfmt::skip]
pub(super) const VEHICLES: &[Row] = &[
    ("vehicle.audi.a2", Car, "", 1, Plain, 1000.0, [1.852685, 0.894339, 0.774525], [0.0, 0.0, 0.7818]),
    ("vehicle.audi.etron", Car, "electric", 1, Plain, 2490.0, [2.427854, 1.016378, 0.82468], [-0.0036, 0.0, 0.8205]),
    ("vehicle.audi.tt", Car, "", 1, Plain, 1350.0, [2.090605, 0.997059, 0.692648], [-0.0004, 0.0, 0.6926]),
    ("vehicle.bh.crossbike", Bicycle, "", 1, Plain, 90.0, [0.754661, 0.43297, 0.806177], [0.0, 0.0, 0.8082]),
    ("vehicle.bmw.grandtourer", Car, "", 1, Plain, 1550.0, [2.305503, 1.120857, 0.833638], [0.0, -0.0005, 0.7651]),
    ("vehicle.carlamotors.carlacola", Truck, "", 1, Plain, 5500.0, [2.601919, 1.313495, 1.233722], [0.0, 0.0, 1.2337]),
    ("vehicle.carlamotors.european_hgv", Truck, "", 2, Plain, 9000.0, [3.967855, 1.445544, 1.730972], [0.0127, 0.0053, 1.7306]),
    ("vehicle.carlamotors.firetruck", Truck, "emergency", 2, Doors, 12000.0, [4.234021, 1.445544, 1.913706], [-0.2534, 0.0053, 1.9133]),
    ("vehicle.chevrolet.impala", Car, "", 1, Plain, 1700.0, [2.67874, 1.016601, 0.705329], [0.0001, 0.0018, 0.7015]),
    ("vehicle.citroen.c3", Car, "", 1, Plain, 1100.0, [1.993842, 0.925424, 0.808555], [0.0, 0.0024, 0.7619]),
    ("vehicle.diamondback.century", Bicycle, "", 1, Plain, 85.0, [0.828122, 0.291219, 0.809883], [0.0, 0.0, 0.8157]),
    ("vehicle.dodge.charger_2020", Car, "", 2, Doors, 1850.0, [2.503913, 0.940811, 0.767362], [-0.0053, 0.0, 0.7656]),
    ("vehicle.dodge.charger_police", Car, "emergency", 1, Plain, 1900.0, [2.487122, 1.019201, 0.771059], [0.0236, 0.0006, 0.7927]),
    ("vehicle.dodge.charger_police_2020", Car, "emergency", 2, Doors, 1950.0, [2.618757, 0.96488, 0.819192], [0.1095, 0.0, 0.8174]),
    ("vehicle.ford.ambulance", Van, "emergency", 2, Doors, 4500.0, [3.182822, 1.175587, 1.215688], [-0.2886, 0.0019, 1.2156]),
    ("vehicle.ford.crown", Car, "taxi", 2, Doors, 1850.0, [2.682839, 0.900362, 0.787483], [0.1854, 0.0, 0.7684]),
    ("vehicle.ford.mustang", Car, "", 1, Plain, 1700.0, [2.358763, 0.947413, 0.65047], [0.0321, 0.0, 0.6505]),
    ("vehicle.gazelle.omafiets", Bicycle, "", 1, Plain, 95.0, [0.921721, 0.329521, 0.887914], [-0.01, 0.0, 0.8946]),
    ("vehicle.harley-davidson.low_rider", Motorcycle, "", 1, Plain, 380.0, [1.175088, 0.383117, 0.824747], [0.0, 0.0, 0.8246]),
    ("vehicle.jeep.wrangler_rubicon", Car, "", 1, Plain, 1900.0, [1.93311, 0.952598, 0.938968], [0.0002, 0.001, 0.9323]),
    ("vehicle.kawasaki.ninja", Motorcycle, "", 1, Plain, 270.0, [1.021842, 0.398456, 0.761596], [0.0, 0.0, 0.7689]),
    ("vehicle.lincoln.mkz_2017", Car, "", 1, Plain, 1700.0, [2.450842, 1.064162, 0.755373], [0.004, 0.0, 0.7189]),
    ("vehicle.lincoln.mkz_2020", Car, "", 2, Doors, 1700.0, [2.446191, 0.918357, 0.745139], [-0.0063, 0.0, 0.7488]),
    ("vehicle.mercedes.coupe", Car, "", 1, Plain, 1750.0, [2.513388, 1.075773, 0.825326], [0.0, -0.0008, 0.6668]),
    ("vehicle.mercedes.coupe_2020", Car, "", 2, Doors, 1750.0, [2.336819, 0.905906, 0.720974], [-0.0026, 0.0, 0.7204]),
    ("vehicle.mercedes.sprinter", Van, "", 2, Doors, 2400.0, [2.957595, 0.994216, 1.280328], [-0.0105, 0.0041, 1.2882]),
    ("vehicle.micro.microlino", Car, "electric", 1, Plain, 550.0, [1.103648, 0.74046, 0.688012], [0.0, -0.0001, 0.6772]),
    ("vehicle.mini.cooper_s", Car, "", 1, Plain, 1250.0, [1.9029, 0.985138, 0.737515], [0.0, -0.0001, 0.693]),
    ("vehicle.mini.cooper_s_2021", Car, "", 2, Doors, 1400.0, [2.27635, 1.048536, 0.883583], [-0.0313, 0.0, 0.891]),
    ("vehicle.mitsubishi.fusorosa", Bus, "", 2, Lights, 6000.0, [5.136343, 1.972076, 2.126424], [-0.4452, -0.1209, 2.1274]),
    ("vehicle.nissan.micra", Car, "", 1, Plain, 950.0, [1.816688, 0.922557, 0.750641], [0.0, 0.001, 0.7812]),
    ("vehicle.nissan.patrol", Car, "", 1, Plain, 2100.0, [2.302255, 0.965796, 0.927423], [-0.0574, 0.0002, 0.9351]),
    ("vehicle.nissan.patrol_2021", Car, "", 2, Doors, 2750.0, [2.782914, 1.074983, 1.022574], [0.0284, 0.0, 1.0167]),
    ("vehicle.seat.leon", Car, "", 1, Plain, 1300.0, [2.096415, 0.908093, 0.736916], [-0.0002, -0.0016, 0.7396]),
    ("vehicle.tesla.cybertruck", Truck, "electric", 2, Plain, 3000.0, [3.136777, 1.194787, 1.049096], [0.0, 0.0, 1.0491]),
    ("vehicle.tesla.model3", Car, "electric", 1, Plain, 1850.0, [2.39589, 1.081725, 0.74383], [0.0292, 0.0, 0.7359]),
    ("vehicle.toyota.prius", Car, "electric", 1, Plain, 1400.0, [2.256761, 1.003407, 0.762417], [0.002, -0.0004, 0.7242]),
    ("vehicle.vespa.zx125", Motorcycle, "", 1, Plain, 200.0, [0.908553, 0.43297, 0.795045], [0.01, 0.0, 0.7946]),
    ("vehicle.volkswagen.t2", Van, "", 1, Plain, 1300.0, [2.240218, 1.034658, 1.018896], [0.0013, -0.0005, 1.0145]),
    ("vehicle.volkswagen.t2_2021", Van, "", 2, Doors, 1300.0, [2.221092, 0.887283, 0.993603], [0.1167, -0.0004, 0.9912]),
    ("vehicle.yamaha.yzf", Motorcycle, "", 1, Plain, 270.0, [1.095384, 0.432959, 0.765191], [0.0, 0.0, 0.7746]),
];
