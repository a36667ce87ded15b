#include "tests/contract/driver.h"

#include "contract/driver/ptm_unit.h"

static size_t add(struct driver_write* out, size_t n, uint32_t address, uint32_t data) {
  out[n].address = (uint16_t)address;
  out[n].data = data;
  return n + 1;
}

static uint32_t control(const struct driver_draw* draw) {
  uint32_t word = 0;
  word = PTM_UNIT_SET(word, PTM_UNIT_DRAW_CONTROL_FORMAT, draw->format);
  word = PTM_UNIT_SET(word, PTM_UNIT_DRAW_CONTROL_MIP, draw->mip);
  word = PTM_UNIT_SET(word, PTM_UNIT_DRAW_CONTROL_BILINEAR, draw->bilinear);
  word = PTM_UNIT_SET(word, PTM_UNIT_DRAW_CONTROL_WRAP_U, draw->wrap_u);
  word = PTM_UNIT_SET(word, PTM_UNIT_DRAW_CONTROL_WRAP_V, draw->wrap_v);
  word = PTM_UNIT_SET(word, PTM_UNIT_DRAW_CONTROL_COMBINE, draw->combine);
  word = PTM_UNIT_SET(word, PTM_UNIT_DRAW_CONTROL_COLOR, draw->color);
  return PTM_UNIT_SET(word, PTM_UNIT_DRAW_CONTROL_PALETTE, draw->palette);
}

static uint32_t levels(const struct driver_draw* draw) {
  uint32_t word = PTM_UNIT_SET(0, PTM_UNIT_DRAW_LEVELS_MAP, draw->map.levels);
  word = PTM_UNIT_SET(word, PTM_UNIT_DRAW_LEVELS_COLOR, draw->color_texture.levels);
  return PTM_UNIT_SET(word, PTM_UNIT_DRAW_LEVELS_COLOR_LOD, draw->color_lod);
}

static size_t effects(const struct driver_draw* draw, unsigned d, struct driver_write* out,
                      size_t n) {
  unsigned i, k, s;
  uint32_t word = PTM_UNIT_SET(0, PTM_UNIT_DRAW_PASSES_PASSES, draw->passes);
  for (k = 0; k < PTM_UNIT_EXTRA_PASSES_MAX; ++k) {
    word = PTM_UNIT_SET_AT(word, PTM_UNIT_DRAW_PASSES_SET, k, draw->pass_set[k]);
    word = PTM_UNIT_SET_AT(word, PTM_UNIT_DRAW_PASSES_HALF, k, draw->pass_half[k]);
  }
  if (word != 0) n = add(out, n, PTM_UNIT_DRAW_PASSES(d), word);
  word = PTM_UNIT_SET(0, PTM_UNIT_DRAW_EFFECTS_SETS, draw->sets);
  word = PTM_UNIT_SET(word, PTM_UNIT_DRAW_EFFECTS_STAGES, draw->stages);
  if (word != 0) n = add(out, n, PTM_UNIT_DRAW_EFFECTS(d), word);
  if (draw->argument != 0) n = add(out, n, PTM_UNIT_DRAW_ARGUMENT(d), draw->argument);
  for (s = 0; s < draw->sets; ++s) {
    for (i = 0; i < 6; ++i) {
      word = PTM_UNIT_SET(0, PTM_UNIT_SET_COEFFICIENT_BIAS, draw->set_bias[s][i]);
      word = PTM_UNIT_SET(word, PTM_UNIT_SET_COEFFICIENT_SHIFT, draw->set_shift[s][i]);
      n = add(out, n, PTM_UNIT_SET_COEFFICIENT(d, s, i), word);
    }
  }
  for (i = 0; draw->stages != 0 && i < PTM_UNIT_TABLE_ENTRIES; ++i) {
    n = add(out, n, PTM_UNIT_TABLE_ENTRY(d, i),
            PTM_UNIT_SET(0, PTM_UNIT_TABLE_ENTRY_ENTRY, draw->table[i]));
  }
  return n;
}

size_t driver_writes(const struct driver_draw* draw, unsigned number, struct driver_write* out) {
  const unsigned d = number;
  unsigned i;
  size_t n = 0;
  uint32_t word = PTM_UNIT_SET(0, PTM_UNIT_DRAW_MAP_SIZE_WIDTH, draw->map.width);
  n = add(out, n, PTM_UNIT_DRAW_MAP_SIZE(d),
          PTM_UNIT_SET(word, PTM_UNIT_DRAW_MAP_SIZE_HEIGHT, draw->map.height));
  word = PTM_UNIT_SET(0, PTM_UNIT_DRAW_COLOR_SIZE_WIDTH, draw->color_texture.width);
  n = add(out, n, PTM_UNIT_DRAW_COLOR_SIZE(d),
          PTM_UNIT_SET(word, PTM_UNIT_DRAW_COLOR_SIZE_HEIGHT, draw->color_texture.height));
  n = add(out, n, PTM_UNIT_DRAW_LEVELS(d), levels(draw));
  for (i = 0; i < 6; ++i) {
    word = PTM_UNIT_SET(0, PTM_UNIT_DRAW_COEFFICIENT_BIAS, draw->bias[i]);
    n = add(out, n, PTM_UNIT_DRAW_COEFFICIENT(d, i),
            PTM_UNIT_SET(word, PTM_UNIT_DRAW_COEFFICIENT_SHIFT, draw->shift[i]));
  }
  word = PTM_UNIT_SET(0, PTM_UNIT_DRAW_WEIGHTS_KA, draw->ka);
  word = PTM_UNIT_SET(word, PTM_UNIT_DRAW_WEIGHTS_KD, draw->kd);
  n = add(out, n, PTM_UNIT_DRAW_WEIGHTS(d), PTM_UNIT_SET(word, PTM_UNIT_DRAW_WEIGHTS_KS, draw->ks));
  for (i = 0; i < PTM_UNIT_LEVELS_MAX; ++i) {
    n = add(out, n, PTM_UNIT_DRAW_MAP_BASE(d, i),
            PTM_UNIT_SET(0, PTM_UNIT_DRAW_MAP_BASE_BASE, draw->map.base[i]));
  }
  for (i = 0; i < PTM_UNIT_LEVELS_MAX; ++i) {
    n = add(out, n, PTM_UNIT_DRAW_COLOR_BASE(d, i),
            PTM_UNIT_SET(0, PTM_UNIT_DRAW_COLOR_BASE_BASE, draw->color_texture.base[i]));
  }
  n = effects(draw, d, out, n);
  return add(out, n, PTM_UNIT_DRAW_CONTROL(d), control(draw));
}

struct driver_unit driver_capabilities(const uint32_t words[8]) {
  struct driver_unit unit;
  const uint32_t* at = words;
  unit.tmus = PTM_UNIT_GET(at[0], PTM_UNIT_BUILT_UNIT_TMUS);
  unit.cache_kib = PTM_UNIT_GET(at[0], PTM_UNIT_BUILT_UNIT_CACHE_KIB);
  unit.miss_fifo =
      PTM_UNIT_GET(at[PTM_UNIT_BUILT_FIFOS - PTM_UNIT_BUILT_UNIT], PTM_UNIT_BUILT_FIFOS_MISS_FIFO);
  unit.stages =
      PTM_UNIT_GET(at[PTM_UNIT_BUILT_EFFECTS - PTM_UNIT_BUILT_UNIT], PTM_UNIT_BUILT_EFFECTS_STAGES);
  unit.draws = PTM_UNIT_GET(at[PTM_UNIT_SIZES - PTM_UNIT_BUILT_UNIT], PTM_UNIT_SIZES_DRAWS);
  unit.coef_bits = PTM_UNIT_GET(at[PTM_UNIT_BUILT_EVALUATOR - PTM_UNIT_BUILT_UNIT],
                                PTM_UNIT_BUILT_EVALUATOR_COEF_BITS);
  unit.guard = PTM_UNIT_GET(at[PTM_UNIT_BUILT_EVALUATOR - PTM_UNIT_BUILT_UNIT],
                            PTM_UNIT_BUILT_EVALUATOR_GUARD);
  unit.shift_min = PTM_UNIT_GET_SIGNED(at[PTM_UNIT_BUILT_LUMINANCE - PTM_UNIT_BUILT_UNIT],
                                       PTM_UNIT_BUILT_LUMINANCE_SHIFT_MIN);
  return unit;
}

int driver_knows(uint32_t magic, uint32_t version) {
  return magic == PTM_UNIT_MAGIC_MAGIC_RESET &&
         PTM_UNIT_GET(version, PTM_UNIT_VERSION_MAJOR) == PTM_UNIT_VERSION_MAJOR_RESET;
}

int32_t driver_color_lod(uint32_t word) {
  return PTM_UNIT_GET_SIGNED(word, PTM_UNIT_DRAW_LEVELS_COLOR_LOD);
}

uint32_t driver_errors(uint32_t word, unsigned number) {
  return PTM_UNIT_GET_AT(word, PTM_UNIT_ERRORS_DRAW, number);
}

uint32_t driver_counter_high(unsigned number) { return PTM_UNIT_COUNTER_HIGH(number); }
uint32_t driver_counter_of_cycles(void) { return PTM_UNIT_COUNT_CYCLES; }
