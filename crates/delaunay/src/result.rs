//! What the algorithms return: a mesh that is known to be Delaunay.

use delone_mesh::{CellId, Mesh, VertexId};
use delone_sites::Sites;

/// The Delaunay triangulation of some sites, ties broken by their lexicographic order.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Delaunay<const D: usize> {
    mesh: Mesh<D>,
}

impl<const D: usize> Delaunay<D> {
    /// Takes an algorithm's word that the mesh is Delaunay.
    pub(crate) const fn new(mesh: Mesh<D>) -> Self {
        Self { mesh }
    }

    /// The mesh; vertex `i` is site `i`.
    #[must_use]
    pub const fn mesh(&self) -> &Mesh<D> {
        &self.mesh
    }

    /// The mesh, to be changed: from here on it is no longer known to be Delaunay.
    #[must_use]
    pub fn into_mesh(self) -> Mesh<D> {
        self.mesh
    }

    /// The solid cells by index.
    pub fn cells(&self) -> impl Iterator<Item = CellId> + Clone + '_ {
        self.mesh.solid_cells()
    }

    /// The solid cells as sorted site ids, in lexicographic order; flat, dimension + 1 ids each.
    #[must_use]
    pub fn canonical(&self) -> Vec<u32> {
        self.mesh.canonical(id_of)
    }

    /// A hash of sites and cells that depends on the positions only, not on the order of input.
    #[must_use]
    pub fn fingerprint(&self, sites: &Sites<D>) -> Fingerprint {
        let ranks = sites.ranks();
        let mut hash = Fingerprint::new();
        hash.sites(sites);
        hash.ids(&self.mesh.canonical(|vertex| ranks[vertex.index()]));
        hash
    }
}

/// The vertex as a site.
pub(crate) fn id_of(vertex: VertexId) -> u32 {
    u32::try_from(vertex.index()).expect("a vertex index fits 32 bits")
}

/// A 128-bit FNV-1a hash, printed as 32 hexadecimal digits.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord, Hash)]
pub struct Fingerprint(u128);

impl Default for Fingerprint {
    fn default() -> Self {
        Self::new()
    }
}

impl Fingerprint {
    /// The hash of nothing.
    #[must_use]
    pub const fn new() -> Self {
        Self(0x6c62_272e_07bb_0142_62b8_2175_6295_c58d)
    }

    /// Takes in eight bytes.
    pub fn word(&mut self, word: u64) {
        for byte in word.to_le_bytes() {
            self.0 =
                (self.0 ^ u128::from(byte)).wrapping_mul(0x0000_0000_0100_0000_0000_0000_0000_013b);
        }
    }

    /// Takes in ids, and how many there are.
    pub fn ids(&mut self, ids: &[u32]) {
        self.word(ids.len() as u64);
        ids.iter().for_each(|&id| self.word(u64::from(id)));
    }

    /// Takes in the sites' coordinates in lexicographic order.
    pub fn sites<const D: usize>(&mut self, sites: &Sites<D>) {
        self.word(D as u64);
        self.word(sites.len() as u64);
        for &site in sites.sorted() {
            sites.points()[site as usize].iter().for_each(|c| self.word(c.to_bits()));
        }
    }
}

impl std::fmt::Display for Fingerprint {
    fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        write!(f, "{:032x}", self.0)
    }
}
