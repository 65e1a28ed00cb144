//! Many points asked about at once: taken along Hilbert's curve, so that each is near the last, on several threads.
//!
//! **Invariant.** Points are taken in blocks of one length, and each block starts from nothing: an answer depends on the
//! points alone, not on the number of threads.

use std::num::NonZeroUsize;

use delone_mesh::VertexId;
use delone_predicates::Adaptive;
use delone_sites::{Sites, SitesError};
use rayon::prelude::{ParallelIterator, ParallelSlice};

/// Points that start from nothing together.
const BLOCK: usize = 1024;

/// Sites and queries under one kernel: the queries are the vertices after the sites.
pub(crate) struct Queries<const D: usize> {
    pub(crate) kernel: Adaptive<Vec<[f64; D]>>,
    distinct: Sites<D>,
    first: usize,
}

impl<const D: usize> Queries<D> {
    /// Queries to be answered over these sites.
    pub(crate) fn new(sites: &Sites<D>, queries: &[[f64; D]]) -> Result<Self, SitesError> {
        let distinct = Sites::new(queries)?;
        let kernel = Adaptive::new([sites.points(), distinct.points()].concat());
        Ok(Self { kernel, distinct, first: sites.len() })
    }

    /// The position of a query, and its vertex.
    pub(crate) fn get(&self, query: u32) -> ([f64; D], VertexId) {
        let place = query as usize;
        (self.distinct.points()[place], VertexId::new(self.first + place))
    }

    /// An answer for each point that was asked about, in the order they were given. `answer` gets what its last call in
    /// this block left behind.
    pub(crate) fn answer<S: Default, A: Clone + Send>(
        &self,
        threads: NonZeroUsize,
        answer: impl Fn(&Self, &mut S, u32) -> A + Sync,
    ) -> Vec<A> {
        let order = self.distinct.hilbert_order();
        let block = |queries: &[u32]| {
            let mut state = S::default();
            queries.iter().map(|&query| answer(self, &mut state, query)).collect::<Vec<A>>()
        };
        let alone = threads.get() == 1 || order.len() <= BLOCK;
        let pool = || rayon::ThreadPoolBuilder::new().num_threads(threads.get()).build().ok();
        let found: Vec<Vec<A>> = match (!alone).then(pool).flatten() {
            Some(pool) => pool.install(|| order.par_chunks(BLOCK).map(block).collect()),
            None => order.chunks(BLOCK).map(block).collect(),
        };
        let mut answers = vec![None; order.len()];
        for (&query, found) in order.iter().zip(found.into_iter().flatten()) {
            answers[query as usize] = Some(found);
        }
        let of_site = |&query: &u32| answers[query as usize].clone().expect("each was answered");
        self.distinct.site_of().iter().map(of_site).collect()
    }
}
