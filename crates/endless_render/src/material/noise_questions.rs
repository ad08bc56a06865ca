//! Noise that a material wants, asked for before it is needed, so that it can be found together.

/// Noise of each pixel, seen by its footprint.
pub(super) trait NoiseQuestions<N>: Sized {
    /// One question.
    type Asked: Copy;

    /// None yet; the widths of the pixels on the surface, metres.
    fn new(footprint_m: N) -> Self;

    /// Asks for [`noise::value2`](super::noise::value2), which no footprint filters.
    fn value2(&mut self, p: [N; 2], salt: u32) -> Self::Asked;

    /// Asks for [`noise::filtered_fbm2`](super::noise::filtered_fbm2), of a wavelength that may differ between pixels.
    fn fbm2_of(&mut self, p: [N; 2], wavelength_m: N, octaves: u32) -> Self::Asked;

    /// Asks for [`noise::filtered_fbm2`](super::noise::filtered_fbm2).
    fn fbm2(&mut self, p: [N; 2], wavelength_m: f32, octaves: u32) -> Self::Asked;

    /// What was asked. What is not looked up may not cost anything: look up once, and only what matters.
    fn found(&self) -> impl Fn(Self::Asked) -> N;
}
