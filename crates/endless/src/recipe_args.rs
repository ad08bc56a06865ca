//! The flags of a recipe, from the declaration of its options.

use clap::{
    Arg, ArgAction, ArgMatches, Args, Command, FromArgMatches,
    error::{Error, ErrorKind},
};
use endless_dataset::{OptionKind, RecipeDraft, RecipeOption};
use std::path::PathBuf;

/// The part of a recipe that flags give.
#[derive(Debug)]
pub(crate) struct RecipeArgs {
    /// All but the cameras and the rig.
    pub(crate) draft: RecipeDraft,
    /// The file of the cameras.
    pub(crate) cameras: Option<PathBuf>,
    /// The file of the rig.
    pub(crate) rig: Option<PathBuf>,
}

fn value_name(kind: OptionKind) -> &'static str {
    match kind {
        OptionKind::Whole { .. } => "N",
        OptionKind::Number { .. } => "X",
        OptionKind::Size { .. } => "WxH",
        OptionKind::Word(_) | OptionKind::Text => "WORD",
        OptionKind::Words(_) | OptionKind::WordsOrNone(_) | OptionKind::Maps => "LIST",
        OptionKind::Cameras | OptionKind::Rig | OptionKind::File => "FILE",
        OptionKind::Place => "X,Y",
        OptionKind::Lines => "LINES",
        OptionKind::Folder => "DIR",
        OptionKind::Switch => "",
    }
}

fn help(option: &RecipeOption) -> String {
    format!("{} [default: {}]", option.help_with_words(), option.default.text())
}

fn arg(option: &'static RecipeOption) -> Arg {
    let arg = Arg::new(option.key).long(option.flag()).help(help(option)).help_heading("Recipe");
    match option.kind {
        OptionKind::Switch => arg.action(ArgAction::SetTrue),
        OptionKind::Cameras | OptionKind::Rig | OptionKind::Folder | OptionKind::File => {
            arg.value_name(value_name(option.kind)).value_parser(clap::value_parser!(PathBuf))
        }
        OptionKind::Words(_) | OptionKind::WordsOrNone(_) | OptionKind::Maps => {
            arg.value_name(value_name(option.kind)).action(ArgAction::Append)
        }
        kind => arg.value_name(value_name(kind)).allow_negative_numbers(true),
    }
}

impl Args for RecipeArgs {
    fn augment_args(command: Command) -> Command {
        command.args(RecipeDraft::OPTIONS.iter().map(arg))
    }

    fn augment_args_for_update(command: Command) -> Command {
        Self::augment_args(command)
    }
}

impl FromArgMatches for RecipeArgs {
    fn from_arg_matches(matches: &ArgMatches) -> Result<Self, Error> {
        let mut args = Self { draft: RecipeDraft::default(), cameras: None, rig: None };
        args.update_from_arg_matches(matches)?;
        Ok(args)
    }

    fn update_from_arg_matches(&mut self, matches: &ArgMatches) -> Result<(), Error> {
        for option in RecipeDraft::OPTIONS {
            match option.kind {
                OptionKind::Switch if !matches.get_flag(option.key) => {}
                OptionKind::Switch => self.set(option, "true")?,
                OptionKind::Cameras => self.cameras = matches.get_one(option.key).cloned(),
                OptionKind::Rig => self.rig = matches.get_one(option.key).cloned(),
                // A path need not be text.
                OptionKind::Folder => self.draft.assets = matches.get_one(option.key).cloned(),
                OptionKind::File => self.draft.traffic = matches.get_one(option.key).cloned(),
                _ => {
                    // A list may be given in parts.
                    if let Some(parts) = matches.get_many::<String>(option.key) {
                        self.set(option, &parts.map(String::as_str).collect::<Vec<_>>().join(","))?;
                    }
                }
            }
        }
        Ok(())
    }
}

impl RecipeArgs {
    fn set(&mut self, option: &RecipeOption, text: &str) -> Result<(), Error> {
        self.draft.set(option.key, text).map_err(|reason| {
            let message =
                format!("invalid value '{text}' for '--{} <{}>': {reason}", option.flag(), value_name(option.kind));
            Error::raw(ErrorKind::ValueValidation, message)
        })
    }
}
