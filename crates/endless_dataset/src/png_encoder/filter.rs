//! Filters of rows: bytes as differences to their neighbours (PNG, section 9).

const SUB: u8 = 1;
const UP: u8 = 2;

/// Appends the rows of a band, of so many bytes a pixel, each filtered by what leaves the smaller differences: to the pixel
/// on the left, or to the one above, which the first row does not know.
pub(super) fn rows<const PIXEL: usize>(band: &[u8], row_bytes: usize, out: &mut Vec<u8>) {
    let mut above: Option<&[u8]> = None;
    for row in band.chunks_exact(row_bytes) {
        match above.filter(|above| cost(&row[PIXEL..], &above[PIXEL..]) <= cost(&row[PIXEL..], row)) {
            Some(above) => {
                out.push(UP);
                out.extend(row.iter().zip(above).map(|(here, there)| here.wrapping_sub(*there)));
            }
            None => {
                out.push(SUB);
                out.extend_from_slice(&row[..PIXEL]);
                out.extend(row[PIXEL..].iter().zip(row).map(|(here, there)| here.wrapping_sub(*there)));
            }
        }
        above = Some(row);
    }
}

/// The sum of differences, taken as signed, of a quarter of the bytes.
fn cost(row: &[u8], others: &[u8]) -> u32 {
    const PIECE: usize = 64;
    let pieces = row.chunks(PIECE).zip(others.chunks(PIECE)).step_by(4);
    let difference = |(here, there): (&u8, &u8)| u16::from((here.wrapping_sub(*there) as i8).unsigned_abs());
    pieces.map(|(here, there)| u32::from(here.iter().zip(there).map(difference).sum::<u16>())).sum()
}
