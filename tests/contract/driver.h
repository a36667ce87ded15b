#pragma once
#include <stddef.h>
#include <stdint.h>

/* A driver in C that knows of the unit nothing but contract/driver/ptm_unit.h. */
#ifdef __cplusplus
extern "C" {
#endif

struct driver_texture {
  uint32_t width, height, levels, base[13];
};

struct driver_draw {
  uint32_t format, mip, bilinear, wrap_u, wrap_v, combine, color, palette;
  struct driver_texture map, color_texture;
  int32_t color_lod, bias[6], shift[6];
  uint32_t ka, kd, ks;
  uint32_t sets, passes, pass_set[4], pass_half[4], stages, argument;
  int32_t set_bias[4][6], set_shift[4][6];
  uint16_t table[256];
};

struct driver_write {
  uint16_t address;
  uint32_t data;
};

/* The writes of a draw, its control last; returns how many. `out` has room for 400. */
size_t driver_writes(const struct driver_draw* draw, unsigned number, struct driver_write* out);

/* What the capability registers say; `words` are those from PTM_UNIT_BUILT_UNIT on. */
struct driver_unit {
  uint32_t tmus, cache_kib, miss_fifo, stages, draws, coef_bits, guard;
  int32_t shift_min;
};
struct driver_unit driver_capabilities(const uint32_t words[8]);

/* Whether the unit is one that this driver drives. */
int driver_knows(uint32_t magic, uint32_t version);

/* The signed field color_lod of a register's word. */
int32_t driver_color_lod(uint32_t word);

/* Error bits of a draw. */
uint32_t driver_errors(uint32_t word, unsigned number);

/* Address of a counter's high half. */
uint32_t driver_counter_high(unsigned number);
uint32_t driver_counter_of_cycles(void);

#ifdef __cplusplus
}
#endif
