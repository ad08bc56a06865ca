//! Where a map lies on Earth, as its OpenDRIVE text says.

use endless_road::Georeference;

/// An OpenDRIVE text as our own writer has it, with the georeference that GNSS sensors measure in: the file's own if it is
/// understood, else the town's, else the usual one. Without any the official client warns.
pub(super) fn with_georeference(opendrive: String, of_town: Option<Georeference>) -> String {
    const BEGIN: &str = "<geoReference>";
    const END: &str = "</geoReference>";
    if of_town.is_some() && opendrive.contains(BEGIN) {
        return opendrive;
    }
    let element = format!("{BEGIN}{}{END}", of_town.unwrap_or_default().proj());
    if let Some((before, rest)) = opendrive.split_once(BEGIN)
        && let Some((_, after)) = rest.split_once(END)
    {
        return format!("{before}{element}{after}");
    }
    let Some((begin, end)) = header_tag(&opendrive) else { return opendrive };
    let (tag, after) = (&opendrive[begin..end], &opendrive[end..]);
    match tag.strip_suffix("/>") {
        Some(open) => format!("{}{open}>{element}</header>{after}", &opendrive[..begin]),
        None => format!("{}{element}{after}", &opendrive[..end]),
    }
}

/// Where the tag that begins the header lies.
fn header_tag(opendrive: &str) -> Option<(usize, usize)> {
    let begin = opendrive.find("<header")?;
    let length = opendrive[begin..].find('>')? + 1;
    Some((begin, begin + length))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_text_says_where_it_lies() {
        let other = Georeference::parse("+proj=tmerc +lat_0=49.3 +lon_0=10.6");
        for town in [None, other] {
            let element = format!("<geoReference>{}</geoReference>", town.unwrap_or_default().proj());
            let texts = [
                ("<a><header x=\"1\"/><b/></a>", format!("<a><header x=\"1\">{element}</header><b/></a>")),
                ("<a><header x=\"1\"><u/></header></a>", format!("<a><header x=\"1\">{element}<u/></header></a>")),
                ("<a/>", "<a/>".to_owned()),
            ];
            for (text, with) in texts {
                assert_eq!(with_georeference(text.to_owned(), town), with);
            }
        }
        let lambert = "<header><geoReference>+proj=lcc</geoReference></header>".to_owned();
        assert_eq!(with_georeference(lambert.clone(), other), lambert, "understood");
        let usual = Georeference::default().proj();
        assert_eq!(with_georeference(lambert.clone(), None), lambert.replace("+proj=lcc", &usual));
    }
}
