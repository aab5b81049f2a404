//! Where in a file something is.

use alloc::borrow::ToOwned;
use alloc::string::String;
use core::fmt;

use ::gltf::json::Root;

/// Something in the file that has an index and a name.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Named {
    /// Its index in the file's list of its kind, from 0 up.
    pub index: usize,
    /// Its name, a long one cut short; where the file gives none, the kind and the index, such as `node_3`.
    pub name: String,
}

/// What of a node a channel drives.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash, PartialOrd, Ord)]
pub enum Property {
    /// Its translation.
    Translation,
    /// Its rotation.
    Rotation,
    /// Its scale.
    Scale,
    /// The weights of its mesh's morph targets.
    Weights,
}

/// Where in the file something is.
#[derive(Clone, Debug, PartialEq, Eq)]
#[non_exhaustive]
pub enum Place {
    /// The file as a whole.
    File,
    /// A node.
    Node(Named),
    /// A skin.
    Skin(Named),
    /// One of the inverse bind matrices of a skin.
    InverseBindMatrix {
        /// The skin.
        skin: Named,
        /// Which of its matrices, from 0 up.
        matrix: usize,
        /// The node whose joint it is for.
        node: Named,
    },
    /// An animation.
    Animation(Named),
    /// A channel of an animation.
    Channel {
        /// The animation.
        animation: Named,
        /// Which of its channels, from 0 up.
        channel: usize,
        /// What it drives: the property, and the node. `None` where that is neither of these.
        target: Option<(Property, Named)>,
    },
}

impl Property {
    /// The name in the file.
    pub const fn name(self) -> &'static str {
        match self {
            Self::Translation => "translation",
            Self::Rotation => "rotation",
            Self::Scale => "scale",
            Self::Weights => "weights",
        }
    }
}

impl Named {
    fn new(kind: &str, index: usize, name: Option<&String>) -> Self {
        Self { index, name: quote(&full_name(kind, index, name)) }
    }

    pub(super) fn node(root: &Root, index: usize) -> Self {
        Self::new("node", index, root.nodes.get(index).and_then(|node| node.name.as_ref()))
    }

    pub(super) fn skin(root: &Root, index: usize) -> Self {
        Self::new("skin", index, root.skins[index].name.as_ref())
    }

    pub(super) fn animation(root: &Root, index: usize) -> Self {
        Self::new("animation", index, root.animations[index].name.as_ref())
    }
}

/// A name of the file as it is, or the kind and the index where there is none.
pub(super) fn full_name(kind: &str, index: usize, name: Option<&String>) -> String {
    name.cloned().unwrap_or_else(|| alloc::format!("{kind}_{index}"))
}

/// A piece of the file, to be quoted in an error: at most 40 characters of it, so that an error stays readable.
pub(super) fn quote(text: &str) -> String {
    const LONGEST: usize = 40;
    match text.char_indices().nth(LONGEST) {
        Some((end, _)) => text[..end].to_owned() + "...",
        None => text.to_owned(),
    }
}

impl fmt::Display for Named {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(f, "{} `{}`", self.index, self.name)
    }
}

impl fmt::Display for Place {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::File => write!(f, "file"),
            Self::Node(node) => write!(f, "node {node}"),
            Self::Skin(skin) => write!(f, "skin {skin}"),
            Self::InverseBindMatrix { skin, matrix, node } => {
                write!(f, "skin {skin}, inverse bind matrix {matrix} (of node {node})")
            }
            Self::Animation(animation) => write!(f, "animation {animation}"),
            Self::Channel { animation, channel, target: None } => write!(f, "animation {animation}, channel {channel}"),
            Self::Channel { animation, channel, target: Some((property, node)) } => {
                write!(f, "animation {animation}, channel {channel} ({} of node {node})", property.name())
            }
        }
    }
}
