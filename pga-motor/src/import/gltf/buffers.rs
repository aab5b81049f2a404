//! Buffers, and the accessors into them, with every bound checked before a byte is read or a place for one taken.

use alloc::borrow::ToOwned;
use alloc::collections::BTreeMap;
use alloc::format;
use alloc::string::String;
use alloc::vec::Vec;

use ::gltf::json::Root;
use ::gltf::json::accessor::{Accessor, ComponentType, Type};
use ::gltf::json::validation::{Checked, USize64};

use super::document::{Document, check_index};
use super::error::GltfReason;
use super::place::quote;
use super::uri;

/// Gets the bytes of a buffer from its address, or says why not.
pub(super) type Load<'a> = &'a mut dyn FnMut(&str) -> Result<Vec<u8>, GltfReason>;

/// The buffers of a file, each fetched when it is first needed: those of meshes and images may be missing.
pub(super) struct Buffers<'a> {
    root: &'a Root,
    blob: Option<&'a [u8]>,
    load: Load<'a>,
    /// For each buffer, where in `data` it is.
    slots: Vec<Option<usize>>,
    /// Where in `data` an address leads, so that a file which names one again and again has it in memory once.
    addresses: BTreeMap<&'a str, usize>,
    data: Vec<Vec<u8>>,
}

/// What an accessor may hold.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Content {
    /// Floating point.
    Float,
    /// Floating point, or integers that stand for numbers from -1 or 0 to 1.
    FloatOrNormalized,
}

/// The values of an accessor: as many as `count`, all of them within the buffer.
pub(super) struct Elements<'a, const N: usize> {
    bytes: &'a [u8],
    stride: usize,
    count: usize,
    component: ComponentType,
}

impl<'a> Buffers<'a> {
    pub(super) fn new(document: &'a Document<'a>, load: Load<'a>) -> Self {
        let root = &document.root;
        let slots = alloc::vec![None; root.buffers.len()];
        Self { root, blob: document.blob, load, slots, addresses: BTreeMap::new(), data: Vec::new() }
    }

    /// The bytes of a buffer, as many as it declares.
    fn buffer(&mut self, index: usize) -> Result<&[u8], GltfReason> {
        let buffer = &self.root.buffers[check_index("a buffer", index, self.root.buffers.len())?];
        let bytes: &[u8] = match &buffer.uri {
            None => self.blob.filter(|_| index == 0).unwrap_or_default(),
            Some(uri) => {
                let slot = match self.slots[index] {
                    Some(slot) => slot,
                    None => self.fetch(uri)?,
                };
                self.slots[index] = Some(slot);
                &self.data[slot]
            }
        };
        slice(bytes, 0, buffer.byte_length.0, || format!("buffer {index}"))
    }

    /// Where in `data` the bytes of an address are.
    fn fetch(&mut self, uri: &'a str) -> Result<usize, GltfReason> {
        if let Some(&slot) = self.addresses.get(uri) {
            return Ok(slot);
        }
        self.data.push(uri::data(uri).unwrap_or_else(|| (self.load)(uri))?);
        let slot = self.data.len() - 1;
        self.addresses.insert(uri, slot);
        Ok(slot)
    }

    /// The values of an accessor of vectors with N components, checked to lie within its buffer.
    pub(super) fn elements<const N: usize>(
        &mut self,
        index: usize,
        shape: Type,
        content: Content,
    ) -> Result<Elements<'_, N>, GltfReason> {
        let root = self.root;
        let accessor = &root.accessors[check_index("an accessor", index, root.accessors.len())?];
        let fault = |expected: &str, found: String| GltfReason::Accessor {
            accessor: index,
            expected: expected.to_owned(),
            found,
        };
        let component = check_format(accessor, shape, content).map_err(|(expected, found)| GltfReason::Accessor {
            accessor: index,
            expected,
            found,
        })?;
        if accessor.sparse.is_some() {
            return Err(fault("all values one after the other", "sparse ones".to_owned()));
        }
        let Some(view_index) = accessor.buffer_view.map(|view| view.value()) else {
            return Err(fault("a buffer view", "none".to_owned()));
        };
        let view = &root.buffer_views[check_index("a buffer view", view_index, root.buffer_views.len())?];
        let buffer = self.buffer(view.buffer.value())?;
        let bytes =
            slice(buffer, offset(view.byte_offset), view.byte_length.0, || format!("buffer view {view_index}"))?;
        let size = N * component.size();
        let stride = match view.byte_stride.map_or(0, |stride| stride.0) {
            0 => size,
            stride if stride >= size => stride,
            stride => return Err(fault(&format!("a stride of at least {size} bytes"), format!("{stride}"))),
        };
        let length = match u128::from(accessor.count.0) {
            0 => 0,
            count => (count - 1) * stride as u128 + size as u128,
        };
        let start = offset(accessor.byte_offset);
        let available = (bytes.len() as u128).saturating_sub(start.into());
        if length > available {
            let what = format!("accessor {index}");
            return Err(GltfReason::Truncated { what, expected: length, found: available });
        }
        // Both fit into the buffer, so they fit into its kind of number.
        let (start, length) = (usize::try_from(start).unwrap_or(usize::MAX), length as usize);
        let bytes = bytes.get(start..).and_then(|rest| rest.get(..length)).unwrap_or_default();
        Ok(Elements { bytes, stride, count: accessor.count.0 as usize, component })
    }
}

fn offset(offset: Option<USize64>) -> u64 {
    offset.map_or(0, |offset| offset.0)
}

/// A part of some bytes, or the error that they are too few.
fn slice(bytes: &[u8], start: u64, length: u64, what: impl FnOnce() -> String) -> Result<&[u8], GltfReason> {
    let part = usize::try_from(start).ok().zip(usize::try_from(length).ok());
    part.and_then(|(start, length)| bytes.get(start..)?.get(..length)).ok_or_else(|| GltfReason::Truncated {
        what: what(),
        expected: u128::from(start) + u128::from(length),
        found: bytes.len() as u128,
    })
}

/// The kind of number that an accessor holds, if it is one that may be; otherwise what was expected and what is there.
fn check_format(accessor: &Accessor, shape: Type, content: Content) -> Result<ComponentType, (String, String)> {
    let component = match &accessor.component_type {
        Checked::Valid(component) => Some(component.0),
        Checked::Invalid => None,
    };
    let found_shape = match accessor.type_ {
        Checked::Valid(shape) => Some(shape),
        Checked::Invalid => None,
    };
    let fits = found_shape == Some(shape)
        && match component {
            Some(ComponentType::F32) => true,
            Some(ComponentType::U32) | None => false,
            Some(_) => content == Content::FloatOrNormalized && accessor.normalized,
        };
    if let Some(component) = component.filter(|_| fits) {
        return Ok(component);
    }
    let kinds = match content {
        Content::Float => "float",
        Content::FloatOrNormalized => "float or normalized integers of 8 or 16 bits",
    };
    let normalized = if accessor.normalized { "normalized " } else { "" };
    let shape_name = |shape: Option<Type>| shape.map_or("an unknown shape", name_of_type);
    let expected = format!("{} of {kinds}", shape_name(Some(shape)));
    Err((
        expected,
        format!("{} of {normalized}{}", shape_name(found_shape), component.map_or("an unknown kind", name_of)),
    ))
}

const fn name_of_type(shape: Type) -> &'static str {
    match shape {
        Type::Scalar => "SCALAR",
        Type::Vec2 => "VEC2",
        Type::Vec3 => "VEC3",
        Type::Vec4 => "VEC4",
        Type::Mat2 => "MAT2",
        Type::Mat3 => "MAT3",
        Type::Mat4 => "MAT4",
    }
}

const fn name_of(component: ComponentType) -> &'static str {
    match component {
        ComponentType::I8 => "byte",
        ComponentType::U8 => "unsigned byte",
        ComponentType::I16 => "short",
        ComponentType::U16 => "unsigned short",
        ComponentType::U32 => "unsigned int",
        ComponentType::F32 => "float",
    }
}

impl<const N: usize> Elements<'_, N> {
    pub(super) fn len(&self) -> usize {
        self.count
    }

    /// A value; integers are those from -1 or 0 to 1 that they stand for.
    pub(super) fn get(&self, index: usize) -> [f64; N] {
        let size = self.component.size();
        let element = &self.bytes[index * self.stride..];
        core::array::from_fn(|i| component(self.component, &element[i * size..]))
    }

    /// The distance between two numbers next to each other, where they are integers; 0 for floating point.
    pub(super) fn step(&self) -> f64 {
        match self.component {
            ComponentType::I8 => 1.0 / 127.0,
            ComponentType::U8 => 1.0 / 255.0,
            ComponentType::I16 => 1.0 / 32767.0,
            ComponentType::U16 => 1.0 / 65535.0,
            ComponentType::U32 | ComponentType::F32 => 0.0,
        }
    }
}

/// The number at the start of some bytes, which are enough for it.
fn component(component: ComponentType, bytes: &[u8]) -> f64 {
    fn first<const M: usize>(bytes: &[u8]) -> [u8; M] {
        *bytes.first_chunk().expect("invariant: the elements lie within the buffer")
    }
    match component {
        ComponentType::I8 => (f64::from(i8::from_le_bytes(first(bytes))) / 127.0).max(-1.0),
        ComponentType::U8 => f64::from(u8::from_le_bytes(first(bytes))) / 255.0,
        ComponentType::I16 => (f64::from(i16::from_le_bytes(first(bytes))) / 32767.0).max(-1.0),
        ComponentType::U16 => f64::from(u16::from_le_bytes(first(bytes))) / 65535.0,
        ComponentType::U32 => f64::from(u32::from_le_bytes(first(bytes))),
        ComponentType::F32 => f64::from(f32::from_le_bytes(first(bytes))),
    }
}

/// The error of a buffer beside a file that is read as bytes alone.
pub(super) fn no_files(uri: &str) -> Result<Vec<u8>, GltfReason> {
    Err(GltfReason::Uri { expected: "a buffer within the file or a data address", found: quote(uri) })
}
