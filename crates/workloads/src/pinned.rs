//! Contract: the fingerprint of every workload for n = 100 and seed 7. A change here breaks every recorded seed.
//!
//! Rows marked `twice` were also computed by `contract/independent.py`, which shares no code with this crate; the others
//! are recorded.

use crate::{all, generate};

#[test]
fn contract_of_fingerprints() {
    assert_eq!(all().len(), PINNED.len());
    for (workload, (name, pinned)) in all().iter().zip(PINNED) {
        assert_eq!(workload.name, name, "the order of the list is part of the contract");
        let now = generate(name, 100, 7).unwrap().fingerprint();
        assert_eq!(now, pinned, "{name} is now {now:#018x}");
    }
}

const PINNED: [(&str, u64); 83] = [
    ("uniform", 0x6cdc_587c_b0db_3220), // twice
    ("gauss", 0x3c53_bd75_8595_107b),
    ("clusters", 0x6d52_7107_1c4d_ac20),
    ("kuzmin", 0x63f9_9eed_9915_a2d2), // twice
    ("spiral", 0x7f1f_47b8_644c_9574),
    ("line-horizontal", 0xdbae_45de_29f9_05c0),
    ("line-vertical", 0x1a75_03a0_069c_bb00),
    ("line-diagonal", 0x95ca_9ce0_f9d9_ae5d),
    ("line-inexact", 0x389d_f31d_3504_3f88), // twice
    ("near-collinear", 0x4d1a_ed98_58dc_8bf5),
    ("parallel-lines", 0x1290_13b2_f988_1a65),
    ("one-off-line", 0x81b7_4276_922f_a5cd),
    ("thin-strip", 0xc331_3260_c52e_fbc6),
    ("parabola", 0xa4ba_d7c2_201a_2787),          // twice
    ("grid", 0x44a1_ccad_1999_2f29),              // twice
    ("hexagonal", 0x29d2_beb2_ff42_96f8),         // twice
    ("grid-tilted-exact", 0x5467_088a_3f13_54f3), // twice
    ("grid-tilted", 0xf7b6_be42_d62e_1d41),       // twice
    ("grid-tilted-slightly", 0xc8de_6937_d743_8b4f),
    ("ulp-grid", 0xe14e_72b6_81f8_a6a4),
    ("few-columns", 0xb9f1_3af6_28ae_42a7),
    ("circle", 0x2df4_c5fb_ffec_a01c),
    ("circle-exact", 0x4cbc_3e2f_bd1b_4bf7),
    ("near-cocircular", 0x53bf_8778_d22d_24c7),
    ("full-range", 0xb268_efea_93c9_7466),
    ("denormals", 0xa27f_c227_b5b1_4c39),
    ("largest", 0xb929_f6ee_f577_d134),
    ("scaled-tiny", 0xfd63_9aa0_ef7e_2162), // twice
    ("scaled-huge", 0x25a8_039e_be1d_0686),
    ("far-cluster", 0x3b0f_fc5f_6463_03bf),
    ("two-scales", 0xb8ae_f24c_0506_c8fa),
    ("duplicates", 0xa1b6_07c2_0732_179d),
    ("near-duplicates", 0x552c_6575_f3c4_d45a),
    ("all-equal", 0xfd84_6d3a_737d_9bf5),
    ("falling-sites", 0x7fe3_6e89_2ec4_2f18),   // twice
    ("shuttle", 0xe114_af09_f625_d98d),         // twice
    ("shuffled-column", 0xbb33_7286_95ae_e3bc), // twice
    ("beach", 0x69e3_4a09_3776_5085),           // twice
    ("wheel", 0xdc71_ca32_cf97_4f33),           // twice
    ("uniform-3d", 0x6c7e_970a_059e_9737),      // twice
    ("gauss-3d", 0x5d3e_d23b_5f4d_5a94),
    ("clusters-3d", 0xfa00_6b2b_ac15_4d63),
    ("grid-3d", 0xd2a4_1e24_7d90_cab0),
    ("ulp-grid-3d", 0x5e2d_d9f8_6bf2_f922),
    ("duplicates-3d", 0xc22b_0af4_a6e8_d18b),
    ("sphere", 0x9277_ac7b_661f_7827),
    ("cospherical", 0xc831_11d3_194d_5b0a),
    ("cube-surface", 0xc5f8_d234_b460_463c),
    ("coplanar", 0xc6b8_d3ef_9c3b_349d),
    ("coplanar-tilted", 0x0881_9388_8b66_9936),
    ("near-coplanar", 0xf35d_8de3_3d29_98be),
    ("collinear-3d", 0x41a0_62d3_de10_7065),
    ("skew-lines", 0x1dee_14f3_8bb1_5265),
    ("moment-curve", 0xab38_41fe_906b_8713), // twice
    ("full-range-3d", 0x7d7f_4bb4_bc59_9545),
    ("scaled-tiny-3d", 0x2baf_5532_ba1f_a532),
    ("scaled-huge-3d", 0x57b4_9489_49d1_59a6),
    ("random-segments", 0x4ab9_c390_9cd5_c111),
    ("dense-segments", 0x6e45_a1e8_7fe9_d287),
    ("slits", 0xe307_a920_103b_388b),
    ("comb", 0x0d51_fc84_b957_5b82),
    ("fan", 0xe405_40d0_f763_fb04),
    ("spiral-polygon", 0x3289_3998_0921_6973),
    ("star-polygon", 0x90bd_e73a_3bff_ba39),
    ("nested-polygons", 0xb9fc_00d9_59c0_6505), // twice
    ("coast", 0xd010_5ca3_d558_b657),
    ("coast-tiny", 0x5e5f_7431_a009_13d9),
    ("coast-huge", 0xacaf_44de_377b_38f9),
    ("streets", 0x1c24_f30a_a353_5aad),
    ("hilbert", 0xc076_1549_2ba6_6502),
    ("koch", 0x53fe_4bd8_1ec7_1b09),
    ("rails", 0x80a1_e64e_f8da_27e6),
    ("ladder", 0x86ac_b124_7d72_978a), // twice
    ("ulp-slopes", 0x550e_0b38_2dc2_923d),
    ("triangulated-grid", 0x4ba0_f6d4_75fd_4f32),
    ("cocircular-chords", 0xce96_598e_050b_f631),
    ("touching-polygons", 0x702c_9a10_3d80_cd35),
    ("t-junctions", 0x52af_cbf1_ae49_3f68),
    ("overlaps", 0x5c72_c1a3_775d_d658),
    ("crossing-soup", 0x3abb_ad8c_afdb_4693), // twice
    ("crossing-short", 0x5512_ba60_547b_de55),
    ("crossing-grid", 0xd51c_84a2_06a1_3391),
    ("crossing-star", 0x7eb4_a919_fd64_1545),
];
