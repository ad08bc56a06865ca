#![no_main]

endless_fuzz_programs::fuzz!(endless_fuzz::CARLA);
