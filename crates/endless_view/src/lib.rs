//! `endless view`: a dataset as a page in the browser, served by this process, also while the dataset is being written.
//!
//! [`Viewer::bind`] takes a folder and an address, [`Viewer::run`] answers until somebody stops it. The page is files of
//! `page/`, which the program holds; it asks for data at `/api` (`docs/view.md`).
//!
//! What is asked for is named by numbers and by words of fixed lists: no path ever comes from a request. Paths come from
//! the dataset alone, and `DatasetFolder` opens none that leads out of its folder. Requests under foreign names of
//! this machine are refused, as are all that would change something.
//!
//! ```no_run
//! use endless_view::{ViewSettings, Viewer};
//!
//! let settings = ViewSettings { folder: "out".into(), bind: [127, 0, 0, 1].into(), port: 0 };
//! let viewer = Viewer::bind(&settings)?;
//! println!("http://{}/", viewer.address());
//! viewer.run()?;
//! # Ok::<(), endless_view::ViewError>(())
//! ```

mod cache;
mod camera_files;
mod dataset;
mod depth_color;
mod error;
mod facts;
mod folder;
mod guard;
mod host;
mod image_api;
mod line_index;
mod line_reader;
mod overview;
mod page;
mod picture;
mod refusal;
mod reply;
mod router;
mod server;
mod timeline;
mod video;
mod video_api;

pub use error::ViewError;
pub use server::{Stopper, ViewSettings, Viewer};
