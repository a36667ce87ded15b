/* Written by scripts/contract from the tables of contract/.
 *
 * The register port of the texture unit (docs/spec/unit.md and docs/spec/effects.md, Registers) for
 * a driver in C11. Addresses are of 32-bit words; a bus of bytes has a register at four times its
 * address. A field is read and set with
 *
 *   PTM_UNIT_GET(word, PTM_UNIT_STATE_TAG)
 *   PTM_UNIT_SET(word, PTM_UNIT_DRAW_CONTROL_MIP, PTM_UNIT_MIP_LINEAR)
 *
 * and one of those that repeat in a register with PTM_UNIT_GET_AT(word, NAME, index) and
 * PTM_UNIT_SET_AT(word, NAME, index, value). PTM_UNIT_GET_SIGNED extends the sign of a field in
 * two's complement (NAME_SIGNED is 1). */
#ifndef PTM_UNIT_H
#define PTM_UNIT_H

#include <stdint.h>

#define PTM_UNIT_GET(word, field) ((uint32_t)(((uint32_t)(word) & field##_MASK) >> field##_SHIFT))
#define PTM_UNIT_SET(word, field, value) \
  (((uint32_t)(word) & ~(uint32_t)field##_MASK) | \
   (((uint32_t)(value) << field##_SHIFT) & field##_MASK))
#define PTM_UNIT_GET_AT(word, field, index) \
  ((uint32_t)(((uint32_t)(word) & field##_MASK(index)) >> field##_SHIFT(index)))
#define PTM_UNIT_SET_AT(word, field, index, value) \
  (((uint32_t)(word) & ~(uint32_t)field##_MASK(index)) | \
   (((uint32_t)(value) << field##_SHIFT(index)) & field##_MASK(index)))
#define PTM_UNIT_GET_SIGNED(word, field) \
  ((int32_t)((PTM_UNIT_GET(word, field) ^ (1u << (field##_WIDTH - 1))) - \
             (1u << (field##_WIDTH - 1))))

/* Sizes that are the same in every unit */
#define PTM_UNIT_DRAWS                               4 /* draws whose descriptors the unit holds */
#define PTM_UNIT_DRAW_BITS                           2 /* bits of a draw's number */
#define PTM_UNIT_LEVELS_MAX                          13 /* levels that a texture has at most */
#define PTM_UNIT_LINE_BITS                           26 /* bits of a line's address */
#define PTM_UNIT_SIDE_BITS                           13 /* bits of a texture's width or height */
#define PTM_UNIT_LARGEST_SIDE                        4096 /* texels that a texture has a side at most */
#define PTM_UNIT_PROBES_LOG2_MAX                     4 /* largest log2 of a fragment's probes */
#define PTM_UNIT_LRGB_PALETTES                       4 /* palettes of LRGB */
#define PTM_UNIT_LRGB_INDEX_BITS                     8 /* log2 of the entries of a palette of LRGB */
#define PTM_UNIT_RGB_INDEX_BITS                      12 /* log2 of the entries of the palette of RGB */
#define PTM_UNIT_EXTRA_SETS_MAX                      4 /* coefficient sets that effects add at most */
#define PTM_UNIT_EXTRA_PASSES_MAX                    4 /* evaluator passes that effects add at most */
#define PTM_UNIT_STAGES_MAX                          8 /* stages behind the combine stage at most */
#define PTM_UNIT_TABLE_ENTRIES                       256 /* entries of a draw's table for stages */

/* Codes: format of a map's texels */
#define PTM_UNIT_FORMAT_NONE                         0u
#define PTM_UNIT_FORMAT_LRGB                         1u
#define PTM_UNIT_FORMAT_RGB                          2u
#define PTM_UNIT_FORMAT_PALETTE_LRGB                 3u
#define PTM_UNIT_FORMAT_PALETTE_RGB                  4u

/* Codes: which levels of a texture are filtered */
#define PTM_UNIT_MIP_NONE                            0u
#define PTM_UNIT_MIP_NEAREST                         1u
#define PTM_UNIT_MIP_LINEAR                          2u

/* Codes: what lies beyond a texture's edge */
#define PTM_UNIT_WRAP_REPEAT                         0u
#define PTM_UNIT_WRAP_MIRROR                         1u
#define PTM_UNIT_WRAP_CLAMP                          2u

/* Codes: what becomes of the map's colour and the colour texture's */
#define PTM_UNIT_COMBINE_NONE                        0u
#define PTM_UNIT_COMBINE_MODULATE                    1u
#define PTM_UNIT_COMBINE_DECAL                       2u
#define PTM_UNIT_COMBINE_BLEND                       3u
#define PTM_UNIT_COMBINE_ADD                         4u
#define PTM_UNIT_COMBINE_REPLACE                     5u

/* Counters: numbers of PTM_UNIT_COUNTER_LOW and PTM_UNIT_COUNTER_HIGH */
#define PTM_UNIT_COUNT_FRAGMENTS                     0u
#define PTM_UNIT_COUNT_PIXELS                        1u
#define PTM_UNIT_COUNT_CYCLES                        2u
#define PTM_UNIT_COUNT_CYCLES_MOVED                  3u
#define PTM_UNIT_COUNT_CYCLES_OUTPUT_BLOCKED         4u
#define PTM_UNIT_COUNT_CYCLES_LINE_WAIT              5u
#define PTM_UNIT_COUNT_CYCLES_RING_FULL              6u
#define PTM_UNIT_COUNT_CYCLES_INPUT_EMPTY            7u
#define PTM_UNIT_COUNT_BEATS                         8u
#define PTM_UNIT_COUNT_BANK_CONFLICTS                9u
#define PTM_UNIT_COUNT_WORDS                         10u
#define PTM_UNIT_COUNT_TAPS                          11u
#define PTM_UNIT_COUNT_TAG_HITS                      12u
#define PTM_UNIT_COUNT_TAG_MISSES                    13u
#define PTM_UNIT_COUNT_LINES_READ                    14u
#define PTM_UNIT_COUNT_DUPLICATE_LINES               15u
#define PTM_UNIT_COUNT_PALETTE_LOOKUPS               16u
#define PTM_UNIT_COUNT_MULTIPLIES_ADDRESS            17u
#define PTM_UNIT_COUNT_MULTIPLIES_FILTER             18u
#define PTM_UNIT_COUNT_MULTIPLIES_EVAL               19u
#define PTM_UNIT_COUNT_MULTIPLIES_COMBINE            20u
#define PTM_UNIT_COUNT_HITS_D0_MAP                   21u
#define PTM_UNIT_COUNT_MISSES_D0_MAP                 22u
#define PTM_UNIT_COUNT_HITS_D0_COLOR                 23u
#define PTM_UNIT_COUNT_MISSES_D0_COLOR               24u
#define PTM_UNIT_COUNT_HITS_D1_MAP                   25u
#define PTM_UNIT_COUNT_MISSES_D1_MAP                 26u
#define PTM_UNIT_COUNT_HITS_D1_COLOR                 27u
#define PTM_UNIT_COUNT_MISSES_D1_COLOR               28u
#define PTM_UNIT_COUNT_HITS_D2_MAP                   29u
#define PTM_UNIT_COUNT_MISSES_D2_MAP                 30u
#define PTM_UNIT_COUNT_HITS_D2_COLOR                 31u
#define PTM_UNIT_COUNT_MISSES_D2_COLOR               32u
#define PTM_UNIT_COUNT_HITS_D3_MAP                   33u
#define PTM_UNIT_COUNT_MISSES_D3_MAP                 34u
#define PTM_UNIT_COUNT_HITS_D3_COLOR                 35u
#define PTM_UNIT_COUNT_MISSES_D3_COLOR               36u
#define PTM_UNIT_COUNT_MULTIPLIES_EFFECTS            37u
#define PTM_UNIT_COUNTERS                            38u

/* Addresses 0x0000 to 0x00ff: draw descriptors */

/* draw d's control, written last, starts the check; rw, while the unit is idle only */
#define PTM_UNIT_DRAW_CONTROL(d)                     (0x0u + 64u * (d))
#define PTM_UNIT_DRAW_CONTROL_FORMAT_SHIFT           0
#define PTM_UNIT_DRAW_CONTROL_FORMAT_MASK            0x7u
#define PTM_UNIT_DRAW_CONTROL_FORMAT_WIDTH           3
#define PTM_UNIT_DRAW_CONTROL_MIP_SHIFT              3
#define PTM_UNIT_DRAW_CONTROL_MIP_MASK               0x18u
#define PTM_UNIT_DRAW_CONTROL_MIP_WIDTH              2
#define PTM_UNIT_DRAW_CONTROL_BILINEAR_SHIFT         5
#define PTM_UNIT_DRAW_CONTROL_BILINEAR_MASK          0x20u
#define PTM_UNIT_DRAW_CONTROL_BILINEAR_WIDTH         1
#define PTM_UNIT_DRAW_CONTROL_WRAP_U_SHIFT           6
#define PTM_UNIT_DRAW_CONTROL_WRAP_U_MASK            0xc0u
#define PTM_UNIT_DRAW_CONTROL_WRAP_U_WIDTH           2
#define PTM_UNIT_DRAW_CONTROL_WRAP_V_SHIFT           8
#define PTM_UNIT_DRAW_CONTROL_WRAP_V_MASK            0x300u
#define PTM_UNIT_DRAW_CONTROL_WRAP_V_WIDTH           2
#define PTM_UNIT_DRAW_CONTROL_COMBINE_SHIFT          10
#define PTM_UNIT_DRAW_CONTROL_COMBINE_MASK           0x1c00u
#define PTM_UNIT_DRAW_CONTROL_COMBINE_WIDTH          3
#define PTM_UNIT_DRAW_CONTROL_COLOR_SHIFT            13
#define PTM_UNIT_DRAW_CONTROL_COLOR_MASK             0x2000u
#define PTM_UNIT_DRAW_CONTROL_COLOR_WIDTH            1
#define PTM_UNIT_DRAW_CONTROL_PALETTE_SHIFT          14
#define PTM_UNIT_DRAW_CONTROL_PALETTE_MASK           0xc000u
#define PTM_UNIT_DRAW_CONTROL_PALETTE_WIDTH          2

/* the map; rw, while the unit is idle only */
#define PTM_UNIT_DRAW_MAP_SIZE(d)                    (0x1u + 64u * (d))
#define PTM_UNIT_DRAW_MAP_SIZE_WIDTH_SHIFT           0
#define PTM_UNIT_DRAW_MAP_SIZE_WIDTH_MASK            0x1fffu
#define PTM_UNIT_DRAW_MAP_SIZE_WIDTH_WIDTH           13
#define PTM_UNIT_DRAW_MAP_SIZE_HEIGHT_SHIFT          16
#define PTM_UNIT_DRAW_MAP_SIZE_HEIGHT_MASK           0x1fff0000u
#define PTM_UNIT_DRAW_MAP_SIZE_HEIGHT_WIDTH          13

/* the colour texture; rw, while the unit is idle only */
#define PTM_UNIT_DRAW_COLOR_SIZE(d)                  (0x2u + 64u * (d))
#define PTM_UNIT_DRAW_COLOR_SIZE_WIDTH_SHIFT         0
#define PTM_UNIT_DRAW_COLOR_SIZE_WIDTH_MASK          0x1fffu
#define PTM_UNIT_DRAW_COLOR_SIZE_WIDTH_WIDTH         13
#define PTM_UNIT_DRAW_COLOR_SIZE_HEIGHT_SHIFT        16
#define PTM_UNIT_DRAW_COLOR_SIZE_HEIGHT_MASK         0x1fff0000u
#define PTM_UNIT_DRAW_COLOR_SIZE_HEIGHT_WIDTH        13

/* levels of both textures, and the colour texture's level of detail; rw, while the unit is idle
 * only */
#define PTM_UNIT_DRAW_LEVELS(d)                      (0x3u + 64u * (d))
#define PTM_UNIT_DRAW_LEVELS_MAP_SHIFT               0
#define PTM_UNIT_DRAW_LEVELS_MAP_MASK                0xfu
#define PTM_UNIT_DRAW_LEVELS_MAP_WIDTH               4
#define PTM_UNIT_DRAW_LEVELS_COLOR_SHIFT             8
#define PTM_UNIT_DRAW_LEVELS_COLOR_MASK              0xf00u
#define PTM_UNIT_DRAW_LEVELS_COLOR_WIDTH             4
#define PTM_UNIT_DRAW_LEVELS_COLOR_LOD_SHIFT         16
#define PTM_UNIT_DRAW_LEVELS_COLOR_LOD_MASK          0x1fff0000u
#define PTM_UNIT_DRAW_LEVELS_COLOR_LOD_WIDTH         13
#define PTM_UNIT_DRAW_LEVELS_COLOR_LOD_SIGNED        1

/* coefficient i of the map; rw, while the unit is idle only */
#define PTM_UNIT_DRAW_COEFFICIENT(d, i)              (0x4u + 64u * (d) + 1u * (i))
#define PTM_UNIT_DRAW_COEFFICIENT_BIAS_SHIFT         0
#define PTM_UNIT_DRAW_COEFFICIENT_BIAS_MASK          0xfffu
#define PTM_UNIT_DRAW_COEFFICIENT_BIAS_WIDTH         12
#define PTM_UNIT_DRAW_COEFFICIENT_SHIFT_SHIFT        16
#define PTM_UNIT_DRAW_COEFFICIENT_SHIFT_MASK         0x1f0000u
#define PTM_UNIT_DRAW_COEFFICIENT_SHIFT_WIDTH        5
#define PTM_UNIT_DRAW_COEFFICIENT_SHIFT_SIGNED       1

/* weights, Q1.8; rw, while the unit is idle only */
#define PTM_UNIT_DRAW_WEIGHTS(d)                     (0xau + 64u * (d))
#define PTM_UNIT_DRAW_WEIGHTS_KA_SHIFT               0
#define PTM_UNIT_DRAW_WEIGHTS_KA_MASK                0x1ffu
#define PTM_UNIT_DRAW_WEIGHTS_KA_WIDTH               9
#define PTM_UNIT_DRAW_WEIGHTS_KD_SHIFT               9
#define PTM_UNIT_DRAW_WEIGHTS_KD_MASK                0x3fe00u
#define PTM_UNIT_DRAW_WEIGHTS_KD_WIDTH               9
#define PTM_UNIT_DRAW_WEIGHTS_KS_SHIFT               18
#define PTM_UNIT_DRAW_WEIGHTS_KS_MASK                0x7fc0000u
#define PTM_UNIT_DRAW_WEIGHTS_KS_WIDTH               9

/* extra passes of the evaluator; rw, while the unit is idle only */
#define PTM_UNIT_DRAW_PASSES(d)                      (0xcu + 64u * (d))
#define PTM_UNIT_DRAW_PASSES_PASSES_SHIFT            0
#define PTM_UNIT_DRAW_PASSES_PASSES_MASK             0x7u
#define PTM_UNIT_DRAW_PASSES_PASSES_WIDTH            3
#define PTM_UNIT_DRAW_PASSES_SET_SHIFT(k)            (4u + 4u * (k))
#define PTM_UNIT_DRAW_PASSES_SET_MASK(k)             (0x70u << (4u * (k)))
#define PTM_UNIT_DRAW_PASSES_SET_WIDTH               3
#define PTM_UNIT_DRAW_PASSES_HALF_SHIFT(k)           (7u + 4u * (k))
#define PTM_UNIT_DRAW_PASSES_HALF_MASK(k)            (0x80u << (4u * (k)))
#define PTM_UNIT_DRAW_PASSES_HALF_WIDTH              1

/* coefficient sets and stages of the draw; rw, while the unit is idle only */
#define PTM_UNIT_DRAW_EFFECTS(d)                     (0xdu + 64u * (d))
#define PTM_UNIT_DRAW_EFFECTS_SETS_SHIFT             0
#define PTM_UNIT_DRAW_EFFECTS_SETS_MASK              0x7u
#define PTM_UNIT_DRAW_EFFECTS_SETS_WIDTH             3
#define PTM_UNIT_DRAW_EFFECTS_STAGES_SHIFT           8
#define PTM_UNIT_DRAW_EFFECTS_STAGES_MASK            0xff00u
#define PTM_UNIT_DRAW_EFFECTS_STAGES_WIDTH           8

/* what stages want to know; rw, while the unit is idle only */
#define PTM_UNIT_DRAW_ARGUMENT(d)                    (0xeu + 64u * (d))
#define PTM_UNIT_DRAW_ARGUMENT_ARGUMENT_SHIFT        0
#define PTM_UNIT_DRAW_ARGUMENT_ARGUMENT_MASK         0xffffffffu
#define PTM_UNIT_DRAW_ARGUMENT_ARGUMENT_WIDTH        32

/* the map's level l; rw, while the unit is idle only */
#define PTM_UNIT_DRAW_MAP_BASE(d, l)                 (0x10u + 64u * (d) + 1u * (l))
#define PTM_UNIT_DRAW_MAP_BASE_BASE_SHIFT            0
#define PTM_UNIT_DRAW_MAP_BASE_BASE_MASK             0x3ffffffu
#define PTM_UNIT_DRAW_MAP_BASE_BASE_WIDTH            26

/* the colour texture's level l; rw, while the unit is idle only */
#define PTM_UNIT_DRAW_COLOR_BASE(d, l)               (0x20u + 64u * (d) + 1u * (l))
#define PTM_UNIT_DRAW_COLOR_BASE_BASE_SHIFT          0
#define PTM_UNIT_DRAW_COLOR_BASE_BASE_MASK           0x3ffffffu
#define PTM_UNIT_DRAW_COLOR_BASE_BASE_WIDTH          26

/* Addresses 0x1000 to 0x101f: command, state, events, identification, capabilities */

/* the bits act in the cycle of the write; wo */
#define PTM_UNIT_COMMAND                             0x1000u
#define PTM_UNIT_COMMAND_INVALIDATE_SHIFT            0
#define PTM_UNIT_COMMAND_INVALIDATE_MASK             0x1u
#define PTM_UNIT_COMMAND_INVALIDATE_WIDTH            1
#define PTM_UNIT_COMMAND_CLEAR_SHIFT                 1
#define PTM_UNIT_COMMAND_CLEAR_MASK                  0x2u
#define PTM_UNIT_COMMAND_CLEAR_WIDTH                 1

/* lines of the memory, 2^26 at most: what draws are checked against; rw, while the unit is idle
 * only */
#define PTM_UNIT_MEMORY_LINES                        0x1001u
#define PTM_UNIT_MEMORY_LINES_LINES_SHIFT            0
#define PTM_UNIT_MEMORY_LINES_LINES_MASK             0x7ffffffu
#define PTM_UNIT_MEMORY_LINES_LINES_WIDTH            27

/* error bits of the draws; ro */
#define PTM_UNIT_ERRORS                              0x1002u
#define PTM_UNIT_ERRORS_DRAW_SHIFT(d)                (0u + 8u * (d))
#define PTM_UNIT_ERRORS_DRAW_MASK(d)                 (0xfu << (8u * (d)))
#define PTM_UNIT_ERRORS_DRAW_WIDTH                   4

/* what the unit is doing; ro */
#define PTM_UNIT_STATE                               0x1003u
#define PTM_UNIT_STATE_BUSY_SHIFT                    0
#define PTM_UNIT_STATE_BUSY_MASK                     0x1u
#define PTM_UNIT_STATE_BUSY_WIDTH                    1
#define PTM_UNIT_STATE_WRONG_TAG_SHIFT               1
#define PTM_UNIT_STATE_WRONG_TAG_MASK                0x2u
#define PTM_UNIT_STATE_WRONG_TAG_WIDTH               1
#define PTM_UNIT_STATE_DRAINING_SHIFT                2
#define PTM_UNIT_STATE_DRAINING_MASK                 0x4u
#define PTM_UNIT_STATE_DRAINING_WIDTH                1
#define PTM_UNIT_STATE_TAG_SHIFT                     8
#define PTM_UNIT_STATE_TAG_MASK                      0xff00u
#define PTM_UNIT_STATE_TAG_WIDTH                     8

/* the line of every request is the unit's line plus this, modulo 2^26; rw, while the unit is
 * idle only */
#define PTM_UNIT_MEMORY_BASE                         0x1004u
#define PTM_UNIT_MEMORY_BASE_BASE_SHIFT              0
#define PTM_UNIT_MEMORY_BASE_BASE_MASK               0x3ffffffu
#define PTM_UNIT_MEMORY_BASE_BASE_WIDTH              26

/* what a palette's word has beyond 32 bits, for the writes of palettes that follow; rw, while
 * the unit is idle only */
#define PTM_UNIT_PALETTE_UPPER                       0x1005u
#define PTM_UNIT_PALETTE_UPPER_BITS_SHIFT            0
#define PTM_UNIT_PALETTE_UPPER_BITS_MASK             0xfu
#define PTM_UNIT_PALETTE_UPPER_BITS_WIDTH            4

/* events; w1c */
#define PTM_UNIT_EVENTS                              0x1008u
#define PTM_UNIT_EVENTS_IDLE_SHIFT                   0
#define PTM_UNIT_EVENTS_IDLE_MASK                    0x1u
#define PTM_UNIT_EVENTS_IDLE_WIDTH                   1
#define PTM_UNIT_EVENTS_DRAW_ERROR_SHIFT             1
#define PTM_UNIT_EVENTS_DRAW_ERROR_MASK              0x2u
#define PTM_UNIT_EVENTS_DRAW_ERROR_WIDTH             1
#define PTM_UNIT_EVENTS_WRONG_TAG_SHIFT              2
#define PTM_UNIT_EVENTS_WRONG_TAG_MASK               0x4u
#define PTM_UNIT_EVENTS_WRONG_TAG_WIDTH              1
#define PTM_UNIT_EVENTS_FAILED_LINE_SHIFT            3
#define PTM_UNIT_EVENTS_FAILED_LINE_MASK             0x8u
#define PTM_UNIT_EVENTS_FAILED_LINE_WIDTH            1
#define PTM_UNIT_EVENTS_REFUSED_SHIFT                4
#define PTM_UNIT_EVENTS_REFUSED_MASK                 0x10u
#define PTM_UNIT_EVENTS_REFUSED_WIDTH                1

/* which events raise the interrupt; rw */
#define PTM_UNIT_ENABLE                              0x1009u
#define PTM_UNIT_ENABLE_EVENTS_SHIFT                 0
#define PTM_UNIT_ENABLE_EVENTS_MASK                  0x1fu
#define PTM_UNIT_ENABLE_EVENTS_WIDTH                 5

/* says that this is the unit; ro */
#define PTM_UNIT_MAGIC                               0x1010u
#define PTM_UNIT_MAGIC_MAGIC_SHIFT                   0
#define PTM_UNIT_MAGIC_MAGIC_MASK                    0xffffffffu
#define PTM_UNIT_MAGIC_MAGIC_WIDTH                   32
#define PTM_UNIT_MAGIC_MAGIC_RESET                   0x50544d55u

/* version of this map; ro */
#define PTM_UNIT_VERSION                             0x1011u
#define PTM_UNIT_VERSION_MINOR_SHIFT                 0
#define PTM_UNIT_VERSION_MINOR_MASK                  0xffffu
#define PTM_UNIT_VERSION_MINOR_WIDTH                 16
#define PTM_UNIT_VERSION_MINOR_RESET                 0x1u
#define PTM_UNIT_VERSION_MAJOR_SHIFT                 16
#define PTM_UNIT_VERSION_MAJOR_MASK                  0xffff0000u
#define PTM_UNIT_VERSION_MAJOR_WIDTH                 16
#define PTM_UNIT_VERSION_MAJOR_RESET                 0x1u

/* parameters of the unit; ro */
#define PTM_UNIT_BUILT_UNIT                          0x1012u
#define PTM_UNIT_BUILT_UNIT_TMUS_SHIFT               0
#define PTM_UNIT_BUILT_UNIT_TMUS_MASK                0x3u
#define PTM_UNIT_BUILT_UNIT_TMUS_WIDTH               2
#define PTM_UNIT_BUILT_UNIT_WAYS_SHIFT               4
#define PTM_UNIT_BUILT_UNIT_WAYS_MASK                0x70u
#define PTM_UNIT_BUILT_UNIT_WAYS_WIDTH               3
#define PTM_UNIT_BUILT_UNIT_CACHE_KIB_SHIFT          8
#define PTM_UNIT_BUILT_UNIT_CACHE_KIB_MASK           0x7f00u
#define PTM_UNIT_BUILT_UNIT_CACHE_KIB_WIDTH          7
#define PTM_UNIT_BUILT_UNIT_PALETTE_LRGB_PORTS_SHIFT 16
#define PTM_UNIT_BUILT_UNIT_PALETTE_LRGB_PORTS_MASK  0x70000u
#define PTM_UNIT_BUILT_UNIT_PALETTE_LRGB_PORTS_WIDTH 3
#define PTM_UNIT_BUILT_UNIT_PALETTE_RGB_PORTS_SHIFT  20
#define PTM_UNIT_BUILT_UNIT_PALETTE_RGB_PORTS_MASK   0x700000u
#define PTM_UNIT_BUILT_UNIT_PALETTE_RGB_PORTS_WIDTH  3
#define PTM_UNIT_BUILT_UNIT_EVAL_LANES_SHIFT         24
#define PTM_UNIT_BUILT_UNIT_EVAL_LANES_MASK          0x3000000u
#define PTM_UNIT_BUILT_UNIT_EVAL_LANES_WIDTH         2
#define PTM_UNIT_BUILT_UNIT_COUNTERS_SHIFT           28
#define PTM_UNIT_BUILT_UNIT_COUNTERS_MASK            0x10000000u
#define PTM_UNIT_BUILT_UNIT_COUNTERS_WIDTH           1
#define PTM_UNIT_BUILT_UNIT_DUPLICATE_LINES_SHIFT    29
#define PTM_UNIT_BUILT_UNIT_DUPLICATE_LINES_MASK     0x20000000u
#define PTM_UNIT_BUILT_UNIT_DUPLICATE_LINES_WIDTH    1

/* places of its FIFOs; ro */
#define PTM_UNIT_BUILT_FIFOS                         0x1013u
#define PTM_UNIT_BUILT_FIFOS_FRAGMENT_FIFO_SHIFT     0
#define PTM_UNIT_BUILT_FIFOS_FRAGMENT_FIFO_MASK      0x7ffu
#define PTM_UNIT_BUILT_FIFOS_FRAGMENT_FIFO_WIDTH     11
#define PTM_UNIT_BUILT_FIFOS_MISS_FIFO_SHIFT         16
#define PTM_UNIT_BUILT_FIFOS_MISS_FIFO_MASK          0x1ff0000u
#define PTM_UNIT_BUILT_FIFOS_MISS_FIFO_WIDTH         9

/* parts that effects use; ro */
#define PTM_UNIT_BUILT_EFFECTS                       0x1014u
#define PTM_UNIT_BUILT_EFFECTS_EXTRA_SETS_SHIFT      0
#define PTM_UNIT_BUILT_EFFECTS_EXTRA_SETS_MASK       0x7u
#define PTM_UNIT_BUILT_EFFECTS_EXTRA_SETS_WIDTH      3
#define PTM_UNIT_BUILT_EFFECTS_EXTRA_PASSES_SHIFT    4
#define PTM_UNIT_BUILT_EFFECTS_EXTRA_PASSES_MASK     0x70u
#define PTM_UNIT_BUILT_EFFECTS_EXTRA_PASSES_WIDTH    3
#define PTM_UNIT_BUILT_EFFECTS_HALF_VECTOR_SHIFT     8
#define PTM_UNIT_BUILT_EFFECTS_HALF_VECTOR_MASK      0x100u
#define PTM_UNIT_BUILT_EFFECTS_HALF_VECTOR_WIDTH     1
#define PTM_UNIT_BUILT_EFFECTS_STAGES_SHIFT          16
#define PTM_UNIT_BUILT_EFFECTS_STAGES_MASK           0xff0000u
#define PTM_UNIT_BUILT_EFFECTS_STAGES_WIDTH          8

/* codes of a draw's control that the unit takes, a bit a code; ro */
#define PTM_UNIT_CHOICES                             0x1015u
#define PTM_UNIT_CHOICES_FORMAT_SHIFT                0
#define PTM_UNIT_CHOICES_FORMAT_MASK                 0xffu
#define PTM_UNIT_CHOICES_FORMAT_WIDTH                8
#define PTM_UNIT_CHOICES_MIP_SHIFT                   8
#define PTM_UNIT_CHOICES_MIP_MASK                    0x700u
#define PTM_UNIT_CHOICES_MIP_WIDTH                   3
#define PTM_UNIT_CHOICES_WRAP_SHIFT                  12
#define PTM_UNIT_CHOICES_WRAP_MASK                   0x7000u
#define PTM_UNIT_CHOICES_WRAP_WIDTH                  3
#define PTM_UNIT_CHOICES_COMBINE_SHIFT               16
#define PTM_UNIT_CHOICES_COMBINE_MASK                0x3f0000u
#define PTM_UNIT_CHOICES_COMBINE_WIDTH               6
#define PTM_UNIT_CHOICES_BILINEAR_SHIFT              24
#define PTM_UNIT_CHOICES_BILINEAR_MASK               0x1000000u
#define PTM_UNIT_CHOICES_BILINEAR_WIDTH              1
#define PTM_UNIT_CHOICES_PROBES_LOG2_SHIFT           28
#define PTM_UNIT_CHOICES_PROBES_LOG2_MASK            0x70000000u
#define PTM_UNIT_CHOICES_PROBES_LOG2_WIDTH           3

/* sizes; ro */
#define PTM_UNIT_SIZES                               0x1016u
#define PTM_UNIT_SIZES_LARGEST_SIDE_SHIFT            0
#define PTM_UNIT_SIZES_LARGEST_SIDE_MASK             0x1fffu
#define PTM_UNIT_SIZES_LARGEST_SIDE_WIDTH            13
#define PTM_UNIT_SIZES_LEVELS_SHIFT                  16
#define PTM_UNIT_SIZES_LEVELS_MASK                   0xf0000u
#define PTM_UNIT_SIZES_LEVELS_WIDTH                  4
#define PTM_UNIT_SIZES_DRAWS_SHIFT                   24
#define PTM_UNIT_SIZES_DRAWS_MASK                    0x7000000u
#define PTM_UNIT_SIZES_DRAWS_WIDTH                   3
#define PTM_UNIT_SIZES_LINE_BITS_SHIFT               27
#define PTM_UNIT_SIZES_LINE_BITS_MASK                0xf8000000u
#define PTM_UNIT_SIZES_LINE_BITS_WIDTH               5

/* palettes; ro */
#define PTM_UNIT_PALETTES                            0x1017u
#define PTM_UNIT_PALETTES_LRGB_PALETTES_SHIFT        0
#define PTM_UNIT_PALETTES_LRGB_PALETTES_MASK         0x7u
#define PTM_UNIT_PALETTES_LRGB_PALETTES_WIDTH        3
#define PTM_UNIT_PALETTES_LRGB_INDEX_BITS_SHIFT      4
#define PTM_UNIT_PALETTES_LRGB_INDEX_BITS_MASK       0xf0u
#define PTM_UNIT_PALETTES_LRGB_INDEX_BITS_WIDTH      4
#define PTM_UNIT_PALETTES_RGB_INDEX_BITS_SHIFT       8
#define PTM_UNIT_PALETTES_RGB_INDEX_BITS_MASK        0xf00u
#define PTM_UNIT_PALETTES_RGB_INDEX_BITS_WIDTH       4

/* parameters of the evaluator; ro */
#define PTM_UNIT_BUILT_EVALUATOR                     0x1018u
#define PTM_UNIT_BUILT_EVALUATOR_COEF_BITS_SHIFT     0
#define PTM_UNIT_BUILT_EVALUATOR_COEF_BITS_MASK      0xfu
#define PTM_UNIT_BUILT_EVALUATOR_COEF_BITS_WIDTH     4
#define PTM_UNIT_BUILT_EVALUATOR_DELTA_BITS_SHIFT    4
#define PTM_UNIT_BUILT_EVALUATOR_DELTA_BITS_MASK     0xf0u
#define PTM_UNIT_BUILT_EVALUATOR_DELTA_BITS_WIDTH    4
#define PTM_UNIT_BUILT_EVALUATOR_LIGHT_INT_SHIFT     8
#define PTM_UNIT_BUILT_EVALUATOR_LIGHT_INT_MASK      0x300u
#define PTM_UNIT_BUILT_EVALUATOR_LIGHT_INT_WIDTH     2
#define PTM_UNIT_BUILT_EVALUATOR_LIGHT_FRAC_SHIFT    12
#define PTM_UNIT_BUILT_EVALUATOR_LIGHT_FRAC_MASK     0xf000u
#define PTM_UNIT_BUILT_EVALUATOR_LIGHT_FRAC_WIDTH    4
#define PTM_UNIT_BUILT_EVALUATOR_BASIS_FRAC_SHIFT    16
#define PTM_UNIT_BUILT_EVALUATOR_BASIS_FRAC_MASK     0x1f0000u
#define PTM_UNIT_BUILT_EVALUATOR_BASIS_FRAC_WIDTH    5
#define PTM_UNIT_BUILT_EVALUATOR_GUARD_SHIFT         24
#define PTM_UNIT_BUILT_EVALUATOR_GUARD_MASK          0xf000000u
#define PTM_UNIT_BUILT_EVALUATOR_GUARD_WIDTH         4
#define PTM_UNIT_BUILT_EVALUATOR_ROUNDING_SHIFT      28
#define PTM_UNIT_BUILT_EVALUATOR_ROUNDING_MASK       0x10000000u
#define PTM_UNIT_BUILT_EVALUATOR_ROUNDING_WIDTH      1

/* parameters of the evaluator; ro */
#define PTM_UNIT_BUILT_LUMINANCE                     0x1019u
#define PTM_UNIT_BUILT_LUMINANCE_LUM_BITS_SHIFT      0
#define PTM_UNIT_BUILT_LUMINANCE_LUM_BITS_MASK       0xfu
#define PTM_UNIT_BUILT_LUMINANCE_LUM_BITS_WIDTH      4
#define PTM_UNIT_BUILT_LUMINANCE_LUM_FRAC_SHIFT      4
#define PTM_UNIT_BUILT_LUMINANCE_LUM_FRAC_MASK       0x70u
#define PTM_UNIT_BUILT_LUMINANCE_LUM_FRAC_WIDTH      3
#define PTM_UNIT_BUILT_LUMINANCE_SHIFT_MIN_SHIFT     8
#define PTM_UNIT_BUILT_LUMINANCE_SHIFT_MIN_MASK      0xf00u
#define PTM_UNIT_BUILT_LUMINANCE_SHIFT_MIN_WIDTH     4
#define PTM_UNIT_BUILT_LUMINANCE_SHIFT_MIN_SIGNED    1
#define PTM_UNIT_BUILT_LUMINANCE_SHIFT_GROUPS_SHIFT  12
#define PTM_UNIT_BUILT_LUMINANCE_SHIFT_GROUPS_MASK   0x7000u
#define PTM_UNIT_BUILT_LUMINANCE_SHIFT_GROUPS_WIDTH  3
#define PTM_UNIT_BUILT_LUMINANCE_FILTER_FRAC_SHIFT   16
#define PTM_UNIT_BUILT_LUMINANCE_FILTER_FRAC_MASK    0x70000u
#define PTM_UNIT_BUILT_LUMINANCE_FILTER_FRAC_WIDTH   3

/* Addresses 0x2000 to 0x207f: counters; 0 if one is not built in */

/* counter n, low half; ro */
#define PTM_UNIT_COUNTER_LOW(n)                      (0x2000u + 2u * (n))
#define PTM_UNIT_COUNTER_LOW_COUNT_SHIFT             0
#define PTM_UNIT_COUNTER_LOW_COUNT_MASK              0xffffffffu
#define PTM_UNIT_COUNTER_LOW_COUNT_WIDTH             32

/* counter n, high half; ro */
#define PTM_UNIT_COUNTER_HIGH(n)                     (0x2001u + 2u * (n))
#define PTM_UNIT_COUNTER_HIGH_COUNT_SHIFT            0
#define PTM_UNIT_COUNTER_HIGH_COUNT_MASK             0xffffffffu
#define PTM_UNIT_COUNTER_HIGH_COUNT_WIDTH            32

/* Addresses 0x2800 to 0x287f: coefficient sets of draws */

/* set s of draw d, coefficient i; rw, while the unit is idle only */
#define PTM_UNIT_SET_COEFFICIENT(d, s, i)            (0x2800u + 32u * (d) + 8u * (s) + 1u * (i))
#define PTM_UNIT_SET_COEFFICIENT_BIAS_SHIFT          0
#define PTM_UNIT_SET_COEFFICIENT_BIAS_MASK           0xfffu
#define PTM_UNIT_SET_COEFFICIENT_BIAS_WIDTH          12
#define PTM_UNIT_SET_COEFFICIENT_SHIFT_SHIFT         16
#define PTM_UNIT_SET_COEFFICIENT_SHIFT_MASK          0x1f0000u
#define PTM_UNIT_SET_COEFFICIENT_SHIFT_WIDTH         5
#define PTM_UNIT_SET_COEFFICIENT_SHIFT_SIGNED        1

/* Addresses 0x3000 to 0x33ff: tables of effect stages */

/* entry i of draw d's table; wo, while the unit is idle only */
#define PTM_UNIT_TABLE_ENTRY(d, i)                   (0x3000u + 256u * (d) + 1u * (i))
#define PTM_UNIT_TABLE_ENTRY_ENTRY_SHIFT             0
#define PTM_UNIT_TABLE_ENTRY_ENTRY_MASK              0xfffu
#define PTM_UNIT_TABLE_ENTRY_ENTRY_WIDTH             12

/* Addresses 0x4000 to 0x47ff: palettised LRGB: entry e = 256 palette + index */

/* palettised LRGB, entry e = 256 palette + index: (a0 a1 a2), (a3 a4 a5); wo, while the unit is
 * idle only */
#define PTM_UNIT_LRGB_PALETTE_WORD(e, w)             (0x4000u + 2u * (e) + 1u * (w))
#define PTM_UNIT_LRGB_PALETTE_WORD_COEFFICIENTS_SHIFT 0
#define PTM_UNIT_LRGB_PALETTE_WORD_COEFFICIENTS_MASK 0xffffffffu
#define PTM_UNIT_LRGB_PALETTE_WORD_COEFFICIENTS_WIDTH 32

/* Addresses 0x8000 to 0xffff: palettised RGB */

/* palettised RGB, entry e: red (a0 a1 a2), (a3 a4 a5), green, blue; wo, while the unit is idle
 * only */
#define PTM_UNIT_RGB_PALETTE_WORD(e, w)              (0x8000u + 8u * (e) + 1u * (w))
#define PTM_UNIT_RGB_PALETTE_WORD_COEFFICIENTS_SHIFT 0
#define PTM_UNIT_RGB_PALETTE_WORD_COEFFICIENTS_MASK  0xffffffffu
#define PTM_UNIT_RGB_PALETTE_WORD_COEFFICIENTS_WIDTH 32

#endif
