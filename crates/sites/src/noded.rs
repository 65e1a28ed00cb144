//! What [`Pslg`] and [`Arrangement`] have in common: segments in pieces that meet in common ends only.

use delone_predicates::Constructed;

use crate::{Arrangement, Chains, Coverage, Pslg, Sites};

/// A noded graph: vertices, segments, and the subsegments that these are cut into.
pub trait Noded {
    /// The sites: vertices 0 to `sites().len() - 1`. Other vertices come after them.
    fn sites(&self) -> &Sites<2>;

    /// The vertices in lexicographic order.
    fn sorted(&self) -> &[u32];

    /// The input segments, their ends as sites.
    fn segments(&self) -> &[[u32; 2]];

    /// The pieces: smaller vertex first, in increasing order, each once.
    fn subsegments(&self) -> &[[u32; 2]];

    /// For each input segment its subsegments from its first end to its second.
    fn chains(&self) -> &Chains;

    /// The double nearest to each vertex: for sites, the vertex itself.
    fn positions(&self) -> &[[f64; 2]];

    /// A kernel over the vertices, to which points can be added.
    fn kernel(&self) -> Constructed<2>;

    /// The place of each vertex in the lexicographic order.
    fn ranks(&self) -> Vec<u32> {
        let mut ranks = vec![0; self.sorted().len()];
        for (rank, &vertex) in (0u32..).zip(self.sorted()) {
            ranks[vertex as usize] = rank;
        }
        ranks
    }

    /// The number of each vertex in a list of all input points followed by the vertices that are no sites.
    fn names(&self) -> Vec<u32> {
        let inputs =
            u32::try_from(self.sites().site_of().len()).expect("points are fewer than ids");
        let added = self.positions().len() - self.sites().len();
        self.sites().input_of().iter().copied().chain((inputs..).take(added)).collect()
    }

    /// How often the input segments cover each subsegment: multiplicities, which overlaps and repeated segments add to.
    fn coverage(&self) -> Vec<Coverage> {
        self.coverage_where(|_| true)
    }

    /// [`Noded::coverage`] by the input segments that are `counted`, by index.
    fn coverage_where(&self, counted: impl Fn(u32) -> bool) -> Vec<Coverage> {
        let mut coverage = vec![Coverage::default(); self.subsegments().len()];
        for ((segment, chain), &[first, _]) in
            (0u32..).zip(self.chains().iter()).zip(self.segments())
        {
            let mut at = first;
            for &piece in chain.iter().filter(|_| counted(segment)) {
                let [low, high] = self.subsegments()[piece as usize];
                let covered = &mut coverage[piece as usize];
                covered.times += 1;
                covered.net += if at == low { 1 } else { -1 };
                at = if at == low { high } else { low };
            }
        }
        coverage
    }
}

macro_rules! noded {
    ($graph:ty) => {
        fn sites(&self) -> &Sites<2> {
            <$graph>::sites(self)
        }

        fn segments(&self) -> &[[u32; 2]] {
            <$graph>::segments(self)
        }

        fn subsegments(&self) -> &[[u32; 2]] {
            <$graph>::subsegments(self)
        }

        fn chains(&self) -> &Chains {
            <$graph>::chains(self)
        }
    };
}

impl Noded for Pslg {
    noded!(Pslg);

    fn sorted(&self) -> &[u32] {
        self.sites().sorted()
    }

    fn positions(&self) -> &[[f64; 2]] {
        self.sites().points()
    }

    fn kernel(&self) -> Constructed<2> {
        Constructed::new(self.sites().points().to_vec())
    }
}

impl Noded for Arrangement {
    noded!(Arrangement);

    fn sorted(&self) -> &[u32] {
        Self::sorted(self)
    }

    fn positions(&self) -> &[[f64; 2]] {
        Self::kernel(self).positions()
    }

    fn kernel(&self) -> Constructed<2> {
        Self::kernel(self).clone()
    }
}
