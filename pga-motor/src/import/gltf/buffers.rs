//! Buffers, and the accessors into them, with every bound checked before a byte is read or a place for one taken.

use alloc::borrow::ToOwned;
use alloc::collections::{BTreeMap, BTreeSet};
use alloc::format;
use alloc::string::String;
use alloc::vec::Vec;

use ::gltf::json::Root;
use ::gltf::json::accessor::sparse::Sparse;
use ::gltf::json::accessor::{Accessor, ComponentType, Type};
use ::gltf::json::buffer::View;
use ::gltf::json::validation::{Checked, USize64};

use super::allowance::{Allowance, MAX_VALUES};
use super::document::{Document, check_index};
use super::error::GltfReason;
use super::place::quote;
use super::sparse::Indices;
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
    /// The accessors whose sparse indices were found in order.
    ordered: BTreeSet<usize>,
    /// How many sparse indices may still be looked at: accessors may share a view.
    sparse: Allowance,
}

/// What an accessor may hold.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Content {
    /// Floating point.
    Float,
    /// Floating point, or integers that stand for numbers from -1 or 0 to 1.
    FloatOrNormalized,
}

/// The values of an accessor: as many as `count`. Those of a view, and those that replace some of them, lie within the buffers;
/// without a view there is nothing that bounds the count.
pub(super) struct Elements<'a, const N: usize> {
    count: usize,
    component: ComponentType,
    /// Where the values are; where `None`, they are zeros.
    base: Option<Base<'a>>,
    overrides: Option<Overrides<'a>>,
}

/// Values in a view, the first one at the start.
struct Base<'a> {
    bytes: &'a [u8],
    stride: usize,
}

/// Values that replace others, one after the other.
struct Overrides<'a> {
    indices: Indices<'a>,
    values: &'a [u8],
}

impl<'a> Buffers<'a> {
    pub(super) fn new(document: &'a Document<'a>, load: Load<'a>) -> Self {
        let root = &document.root;
        let slots = alloc::vec![None; root.buffers.len()];
        let sparse = Allowance::new(MAX_VALUES, "sparse values in all accessors together");
        let (addresses, ordered) = (BTreeMap::new(), BTreeSet::new());
        Self { root, blob: document.blob, load, slots, addresses, data: Vec::new(), ordered, sparse }
    }

    /// Fetches the buffer of a view, where that is not done.
    fn fetch_view(&mut self, index: usize) -> Result<(), GltfReason> {
        let root = self.root;
        let view = &root.buffer_views[check_index("a buffer view", index, root.buffer_views.len())?];
        let buffer = check_index("a buffer", view.buffer.value(), root.buffers.len())?;
        if let (Some(uri), None) = (&root.buffers[buffer].uri, self.slots[buffer]) {
            self.slots[buffer] = Some(self.fetch(uri)?);
        }
        Ok(())
    }

    /// A view, whose buffer was fetched, and its bytes.
    fn view(&self, index: usize) -> Result<(&View, &[u8]), GltfReason> {
        let view = &self.root.buffer_views[index];
        let buffer = self.buffer(view.buffer.value())?;
        let bytes = slice(buffer, offset(view.byte_offset), view.byte_length.0, || format!("buffer view {index}"))?;
        Ok((view, bytes))
    }

    /// The bytes of a buffer that was fetched, as many as it declares.
    fn buffer(&self, index: usize) -> Result<&[u8], GltfReason> {
        let buffer = &self.root.buffers[index];
        let bytes: &[u8] = match self.slots[index] {
            Some(slot) => &self.data[slot],
            None => self.blob.filter(|_| index == 0).unwrap_or_default(),
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

    /// The values of an accessor of vectors with N components, checked to lie within its buffers.
    pub(super) fn elements<const N: usize>(
        &mut self,
        index: usize,
        shape: Type,
        content: Content,
    ) -> Result<Elements<'_, N>, GltfReason> {
        let root = self.root;
        let accessor = &root.accessors[check_index("an accessor", index, root.accessors.len())?];
        let component = check_format(accessor, shape, content).map_err(|(expected, found)| GltfReason::Accessor {
            accessor: index,
            expected,
            found,
        })?;
        let size = N * component.size();
        if let Some(view) = accessor.buffer_view {
            self.fetch_view(view.value())?;
        }
        if let Some(sparse) = &accessor.sparse {
            self.fetch_view(sparse.indices.buffer_view.value())?;
            self.fetch_view(sparse.values.buffer_view.value())?;
            self.check_order(index, sparse, size)?;
        }
        let base = accessor.buffer_view.map(|view| self.base(index, view.value(), size)).transpose()?;
        let overrides = accessor.sparse.as_ref().map(|sparse| self.overrides(index, sparse, size)).transpose()?;
        Ok(Elements { count: count(accessor), component, base, overrides })
    }

    /// The values that an accessor has in a view, each of as many bytes as `size`.
    fn base(&self, accessor: usize, view: usize, size: usize) -> Result<Base<'_>, GltfReason> {
        let (view, bytes) = self.view(view)?;
        let stride = match view.byte_stride.map_or(0, |stride| stride.0) {
            0 => size,
            stride if stride >= size => stride,
            stride => {
                let (expected, found) = (format!("a stride of at least {size} bytes"), format!("{stride}"));
                return Err(GltfReason::Accessor { accessor, expected, found });
            }
        };
        let declared = &self.root.accessors[accessor];
        let length = match u128::from(declared.count.0) {
            0 => 0,
            count => (count - 1) * stride as u128 + size as u128,
        };
        let bytes = part(bytes, offset(declared.byte_offset), length, || format!("accessor {accessor}"))?;
        Ok(Base { bytes, stride })
    }

    /// The values of a sparse accessor that replace others, each of as many bytes as `size`. Their order is not looked at.
    fn overrides(&self, accessor: usize, sparse: &Sparse, size: usize) -> Result<Overrides<'_>, GltfReason> {
        let Checked::Valid(kind) = &sparse.indices.component_type else {
            let expected = "sparse indices of unsigned bytes, shorts or ints".to_owned();
            return Err(GltfReason::Accessor { accessor, expected, found: "an unknown kind".to_owned() });
        };
        let list = |what: &str, view: usize, start: USize64, size: usize| {
            let (view, bytes) = self.view(view)?;
            if let Some(stride) = view.byte_stride.map(|stride| stride.0).filter(|&stride| ![0, size].contains(&stride))
            {
                let (expected, found) = (format!("{what} one after the other"), format!("a stride of {stride} bytes"));
                return Err(GltfReason::Accessor { accessor, expected, found });
            }
            let length = u128::from(sparse.count.0) * size as u128;
            part(bytes, start.0, length, || format!("the {what} of accessor {accessor}"))
        };
        let (indices, values) = (&sparse.indices, &sparse.values);
        let index_size = kind.0.size();
        let indices = list("sparse indices", indices.buffer_view.value(), indices.byte_offset, index_size)?;
        let values = list("sparse values", values.buffer_view.value(), values.byte_offset, size)?;
        Ok(Overrides { indices: Indices::new(indices, index_size), values })
    }

    /// Checks that the indices of a sparse accessor increase and are below its count; once, however often it is asked for.
    fn check_order(&mut self, accessor: usize, sparse: &Sparse, size: usize) -> Result<(), GltfReason> {
        if self.ordered.contains(&accessor) {
            return Ok(());
        }
        let number = self.overrides(accessor, sparse, size)?.indices.len();
        self.sparse.spend(number)?;
        let count = count(&self.root.accessors[accessor]);
        self.overrides(accessor, sparse, size)?.indices.check(count).map_err(|found| {
            let expected = format!("sparse indices that increase and are below {count}");
            GltfReason::Accessor { accessor, expected, found }
        })?;
        self.ordered.insert(accessor);
        Ok(())
    }
}

/// How many values an accessor has. For more than `usize` can count, which takes one without a view, as many as it can.
fn count(accessor: &Accessor) -> usize {
    usize::try_from(accessor.count.0).unwrap_or(usize::MAX)
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

/// A part of a view, or the error that too little is left of it.
fn part(bytes: &[u8], start: u64, length: u128, what: impl FnOnce() -> String) -> Result<&[u8], GltfReason> {
    let rest = usize::try_from(start).ok().and_then(|start| bytes.get(start..)).unwrap_or_default();
    let part = usize::try_from(length).ok().and_then(|length| rest.get(..length));
    part.ok_or_else(|| GltfReason::Truncated { what: what(), expected: length, found: rest.len() as u128 })
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
        let Some(element) = self.bytes(index) else { return [0.0; N] };
        core::array::from_fn(|i| component(self.component, &element[i * size..]))
    }

    /// The bytes from a value on; `None` where it is zero for want of any.
    fn bytes(&self, index: usize) -> Option<&[u8]> {
        let replaced = self.overrides.as_ref().and_then(|overrides| {
            let at = overrides.indices.find(index)?;
            Some(&overrides.values[at * N * self.component.size()..])
        });
        replaced.or_else(|| self.base.as_ref().map(|base| &base.bytes[index * base.stride..]))
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
