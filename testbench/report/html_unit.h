#pragma once
#include <string>

#include "testbench/report/unit_figures.h"

/// The page's section on the whole texture unit; nothing of it stands in a flat scene's page.
namespace ptm::testbench::html {

/// Whether pipeline and rtl agree in every pixel's cycle and every counter; nothing unless both
/// ran or a difference is named.
void add_unit_verdict(std::string& page, const RunResult& result);
void add_unit(std::string& page, const RunResult& result);
/// Entries of the page's list of definitions.
void add_unit_definitions(std::string& page);

/// Parts of add_unit, each given at least one timing.
void add_cycle_classes(std::string& page, const UnitSection& unit);
/// Lines in each window against time, of pipeline and rtl; nothing if neither has windows.
void add_bandwidth(std::string& page, const UnitSection& unit);
void add_texture_table(std::string& page, const UnitSection& unit);
void add_traffic_table(std::string& page, const UnitSection& unit);
void add_speed_table(std::string& page, const UnitSection& unit);
void add_unit_counters(std::string& page, const UnitSection& unit);

/// At most so many steps of the line of bandwidth; more windows are averaged in groups.
inline constexpr std::size_t kBandwidthSteps = 240;

}  // namespace ptm::testbench::html
