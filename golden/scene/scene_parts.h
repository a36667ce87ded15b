#pragma once
#include <string>
#include <vector>

#include "golden/scene/scene.h"
#include "golden/scene/toml_reader.h"
#include "golden/scene/unit_scene.h"

/// Parts of scene files; each throws InputError with the line.
namespace ptm::golden {

/// All four if `node` is null.
[[nodiscard]] std::vector<std::string> read_models(const Reader& reader, const toml::node* node);

/// One [[texture]]; files are relative to `folder`.
[[nodiscard]] TextureSpec read_texture(const TableReader& table,
                                       const std::filesystem::path& folder);

/// Surface keys of a plane, cylinder or sphere: those it may have, and reading them.
[[nodiscard]] std::span<const std::string_view> shape_keys(ShapeKind kind);
[[nodiscard]] Shape read_shape(const TableReader& table, ShapeKind kind);
inline constexpr std::array<std::pair<std::string_view, ShapeKind>, 3> kShapeNames{
    {{"plane", ShapeKind::plane},
     {"cylinder", ShapeKind::cylinder},
     {"sphere", ShapeKind::sphere}}};

/// One [[object]]: geometry only; `draw` is read_draw()'s.
[[nodiscard]] ObjectSpec read_object(const TableReader& table, const std::filesystem::path& folder);
/// What of it is the descriptor's.
[[nodiscard]] DrawSpec read_draw(const TableReader& table,
                                 const std::vector<TextureSpec>& textures);

/// The tables of [[object.effect]], in the order of the rows of effects.def.
[[nodiscard]] std::vector<EffectSpec> read_effects(const TableReader& object,
                                                   const std::vector<TextureSpec>& textures);

/// [hardware] or [memory], as it stands.
[[nodiscard]] Settings read_settings(const TableReader& table);
[[nodiscard]] StressSpec read_stress(const TableReader& table);

}  // namespace ptm::golden
