// SPDX-FileCopyrightText: 2026 The deburr authors
// SPDX-License-Identifier: Apache-2.0
#include "io/las_plan.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <set>

#include "io/las_layout.hpp"
#include "io/scalar_type.hpp"
#include "io/strided.hpp"

namespace deburr {
namespace {

constexpr std::size_t most_point_bytes = 65535;

/// What the values of an attribute have in common.
struct Range {
  bool all_integers = true;  ///< and each of them a double
  double least = 0;
  double most = 0;
};

Range range_of(const Attribute& attribute) {
  Range range;
  std::visit(
      [&]<typename T>(const std::vector<T>& values) {
        if constexpr (std::is_same_v<T, std::string>) {
          range.all_integers = false;
        } else if constexpr (std::is_integral_v<T> && sizeof(T) <= 4) {
          if (values.empty()) return;
          const auto [least, most] = ends_of(std::span(values));
          range.least = least;
          range.most = most;
        } else {
          for (const T value : values) {
            const auto real = static_cast<double>(value);
            // -0 and numbers from 2^53 on are no integers that another type would give back: 2^53
            // + 1 is the same double as 2^53.
            range.all_integers = range.all_integers && real == std::trunc(real) &&
                                 std::abs(real) < 0x1p53 && !(real == 0 && std::signbit(real));
            range.least = std::min(range.least, real);
            range.most = std::max(range.most, real);
          }
        }
      },
      attribute.values);
  return range;
}

class Planner {
 public:
  Planner(const PointCloud& cloud, const std::vector<Column>& columns, const LasHeader* header,
          Losses& losses)
      : cloud_(cloud), columns_(columns), header_(header), losses_(losses) {}

  LasPlan plan(const std::vector<LasRecord>& records) {
    plan_.has_layout = header_ != nullptr;
    plan_.format = header_ != nullptr ? header_->format : best_format();
    plan_.point_bytes = las_point_bytes(plan_.format);
    if (header_ != nullptr && header_->point_bytes > plan_.point_bytes) {
      old_ = parse_las_extras(las_descriptors(records), header_->point_bytes - plan_.point_bytes);
    }
    const std::vector<LasField> fields = las_fields(plan_.format);
    const std::set<std::string_view> replaced = replaced_las_fields(cloud_.layout, fields, old_);
    for (const LasField& field : fields) {
      const Attribute* const attribute = replaced.contains(field.name) ? nullptr : held_in(field);
      plan_.fields.push_back({field, attribute});
      if (attribute != nullptr) held_.insert(attribute);
    }
    for (const Column& c : columns_) {
      if (c.role >= 3) add_normal(c);
      if (c.role == no_role && !held_.contains(c.attribute)) add_extra(c);
    }
    place_extras();
    return std::move(plan_);
  }

 private:
  /// The attribute of this name, if the field holds all its values.
  const Attribute* held_in(const LasField& field) {
    const auto found = std::ranges::find(cloud_.attributes, field.name, &Attribute::name);
    if (found == cloud_.attributes.end() || found->is_list()) return nullptr;
    if (found->type() == field.type && field.bits == 0) return &*found;
    if (field.type == ScalarType::Float32) return nullptr;
    if (found->type() == ScalarType::Float32 && field.type == ScalarType::Float64) return &*found;
    const auto [place, is_new] = ranges_.try_emplace(&*found);
    if (is_new) place->second = range_of(*found);
    const Range& range = place->second;
    if (!range.all_integers) return nullptr;
    if (field.type == ScalarType::Float64) return &*found;
    return with_number_type(field.type, [&]<typename T>(std::type_identity<T>) -> const Attribute* {
      const double most = field.bits > 0 ? static_cast<double>((1U << field.bits) - 1)
                                         : static_cast<double>(std::numeric_limits<T>::max());
      const bool fits = range.least >= static_cast<double>(std::numeric_limits<T>::lowest()) &&
                        range.most <= most;
      return fits ? &*found : nullptr;
    });
  }

  /// The first format that holds most of the attributes in fields of its own. The first four are
  /// those that every program reads.
  unsigned best_format() {
    unsigned best = 0;
    std::ptrdiff_t most = -1;
    for (const unsigned format : {0U, 1U, 2U, 3U, 6U, 7U, 8U}) {
      const bool too_many = format < las_first_modern_format && cloud_.size() > 0xffffffffU;
      if (too_many) continue;
      const std::vector<LasField> fields = las_fields(format);
      const auto held = std::ranges::count_if(
          fields, [&](const LasField& field) { return held_in(field) != nullptr; });
      if (held <= most) continue;
      most = held;
      best = format;
    }
    return best;
  }

  std::string unique_name(const std::string& name) {
    constexpr std::size_t longest = 32;
    std::string base = name;
    std::ranges::replace(base, '\0', '_');  // which ends a name
    std::string unique = base.substr(0, longest);
    for (int n = 2; !names_.insert(unique).second; ++n) {
      const std::string tail = fmt::format("_{}", n);
      unique = base.substr(0, longest - tail.size()) + tail;
    }
    losses_.add_name(name, unique);
    return unique;
  }

  void add(LasExtra extra, const Attribute* attribute, const Column* normal) {
    if (plan_.point_bytes + extra.bytes() > most_point_bytes) {
      losses_.add(fmt::format("LAS has no room for '{}', which was left out", extra.name));
      return;
    }
    plan_.point_bytes += extra.bytes();
    plan_.extras.push_back({std::move(extra), attribute, normal});
  }

  /// Bytes without a description are found behind all others.
  void place_extras() {
    std::ranges::stable_partition(plan_.extras, [](const LasExtraSource& source) {
      return !source.extra.descriptor.empty();
    });
    std::size_t place = las_point_bytes(plan_.format);
    for (LasExtraSource& source : plan_.extras) {
      source.place = place;
      place += source.extra.bytes();
    }
  }

  void add_normal(const Column& c) {
    const bool keeps_name = plan_.has_layout && c.in_layout;
    const std::string name = unique_name(
        keeps_name ? c.name : std::string(role_names[static_cast<std::size_t>(c.role)]));
    const bool is_float = c.type == ScalarType::Float32 && holds_floats(c);
    add(make_las_extra(name, is_float ? ScalarType::Float32 : ScalarType::Float64), nullptr, &c);
  }

  static bool holds_floats(const Column& c) {
    for (std::size_t i = 0; i < c.vectors->size(); ++i) {
      const double value = c.coordinate(i);
      if (!std::isnan(value) && static_cast<double>(static_cast<float>(value)) != value)
        return false;
    }
    return true;
  }

  void add_extra(const Column& column) {
    const Attribute& attribute = *column.attribute;
    if (plan_.has_layout && column.name == attribute.name) {
      // A reader puts marks behind a name that is taken.
      const std::string name = attribute.name.substr(0, attribute.name.find_last_not_of('_') + 1);
      const auto old = std::ranges::find_if(old_, [&](const LasExtra& e) {
        return (e.name == attribute.name || e.name == name) && still_holds(e, attribute);
      });
      if (old != old_.end()) {
        names_.insert(old->name);
        old->is_scaled = old->is_scaled && attribute.type() == ScalarType::Float64;
        add(*old, &attribute, nullptr);
        old_.erase(old);
        return;
      }
    }
    if (attribute.type() == ScalarType::Text || attribute.is_list()) {
      return losses_.add(attribute);
    }
    losses_.add_renamed(column);
    add(make_las_extra(unique_name(column.name), attribute.type()), &attribute, nullptr);
  }

  /// Whether every item has so many values.
  [[nodiscard]] bool has_lists_of(const Attribute& attribute, std::size_t count) const {
    if (!attribute.is_list()) return count == 1;
    for (std::size_t i = 0; i < cloud_.size(); ++i) {
      if (attribute.offsets[i + 1] != (i + 1) * count) return false;
    }
    return true;
  }

  /// Whether a field as the input had it holds the values.
  [[nodiscard]] bool still_holds(const LasExtra& extra, const Attribute& attribute) const {
    if (!has_lists_of(attribute, extra.count)) return false;
    // Also of a scaled field: see LasReader::check_scales().
    if (extra.type == attribute.type()) return true;
    if (!extra.is_scaled || attribute.type() != ScalarType::Float64) return false;
    const auto& values = std::get<std::vector<double>>(attribute.values);
    return with_number_type(extra.type, [&]<typename T>(std::type_identity<T>) {
      for (std::size_t i = 0; i < values.size(); ++i) {
        if (!unscale<T>(extra, i % extra.count, values[i])) return false;
      }
      return true;
    });
  }

  const PointCloud& cloud_;
  const std::vector<Column>& columns_;
  const LasHeader* header_;
  Losses& losses_;
  LasPlan plan_;
  std::map<const Attribute*, Range> ranges_;
  std::set<const Attribute*> held_;
  std::set<std::string> names_;  ///< of extra bytes
  std::vector<LasExtra> old_;
};

}  // namespace

const Attribute* LasPlan::attribute_for(std::string_view field) const {
  const auto found = std::ranges::find_if(
      fields, [&](const LasFieldSource& source) { return source.field.name == field; });
  return found != fields.end() ? found->attribute : nullptr;
}

bool LasPlan::makes_up(std::string_view field) const {
  const bool is_return = field == "return_number" || field == "number_of_returns";
  const bool is_extra = std::ranges::any_of(
      extras, [&](const LasExtraSource& source) { return source.extra.name == field; });
  return is_return && !has_layout && !is_extra && attribute_for(field) == nullptr;
}

LasPlan plan_las(const PointCloud& cloud, const std::vector<Column>& columns,
                 const LasHeader* header, const std::vector<LasRecord>& records, Losses& losses) {
  return Planner(cloud, columns, header, losses).plan(records);
}

}  // namespace deburr
