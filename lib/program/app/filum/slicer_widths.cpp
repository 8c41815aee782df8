#include "app/filum/slicer_widths.hpp"

#include "app/filum/slicer_text.hpp"
#include "base/number.hpp"

#include <algorithm>
#include <array>
#include <cmath>

namespace filum::app::filum {

namespace {

using Words = std::vector<std::string>;

enum Role : std::size_t { kOuter, kInner, kInfill, kSolid, kTop, kSupport, kFirst, kRoles };

struct RoleRow {
    const char* option; // of Filum; "" if the role has none
    const char* prusa;  // keys
    const char* orca;
    bool as_nozzle; // the slicer's own choice is the nozzle's width
};

constexpr std::array<RoleRow, kRoles> kTable{{
    {"bead-width", "external_perimeter_extrusion_width", "outer_wall_line_width", false},
    {"inner-width", "perimeter_extrusion_width", "inner_wall_line_width", false},
    {"infill-width", "infill_extrusion_width", "sparse_infill_line_width", false},
    {"solid-width", "solid_infill_extrusion_width", "internal_solid_infill_line_width", false},
    {"", "top_infill_extrusion_width", "top_surface_line_width", true},
    {"support-width", "support_material_extrusion_width", "support_line_width", true},
    {"first-layer-width", "first_layer_extrusion_width", "initial_layer_line_width", false},
}};
constexpr std::array kGeneral{"extrusion_width", "line_width"};
constexpr double kOwnChoice = 1.125; // nozzle diameters: the width that slicers choose for a width of 0

class RoleWidths {
  public:
    RoleWidths(const SlicerValues& values, const WidthRoles& roles, Words& remarks)
        : values_(values), roles_(roles), remarks_(remarks), nozzle_(values.number_or("nozzle_diameter", 0)) {
        for (std::size_t k = 0; k < kRoles; ++k) mm_[k] = width(static_cast<Role>(k));
    }

    // The options that `key` makes.
    Words words(const std::string& key) {
        Words out;
        for (std::size_t k = 0; k < kRoles; ++k) {
            const auto role = static_cast<Role>(k);
            if (key != maker(role) || !(mm_[role] > 0)) continue;
            if (role == kSolid) tell_top();
            if (!wanted(role)) continue;
            tell_percentage(role);
            out.push_back(std::string("--") + kTable[role].option + "=" + shortest_text(mm_[role]));
        }
        return out;
    }

  private:
    // The key in the file that holds the width of the role itself; "" if there is none.
    [[nodiscard]] std::string own_key(Role role) const {
        for (const char* key : {kTable[role].prusa, kTable[role].orca})
            if (!values_.text(key).empty()) return key;
        return "";
    }
    [[nodiscard]] std::string general_key() const {
        for (const char* key : kGeneral)
            if (!values_.text(key).empty()) return key;
        return "";
    }
    // The key that makes the option of the role.
    [[nodiscard]] std::string maker(Role role) const {
        if (std::string own = own_key(role); !own.empty()) return own;
        const std::string general = general_key();
        return role == kFirst ? "" : general.empty() ? "nozzle_diameter" : general;
    }
    // The key whose value is the width of the role; "" if the slicer chooses the width.
    [[nodiscard]] std::string source(Role role) const {
        for (const std::string& key : {own_key(role), role == kFirst ? "" : general_key()})
            if (!key.empty() && values_.number(key) > 0) return key;
        return "";
    }
    [[nodiscard]] double wide() const { return nozzle_ > 0 ? nozzle_ : 0.4; }

    // Whether a percentage refers to the layer height, not to the nozzle.  Files of unknown slicers are read as those
    // of SuperSlicer if the width would be less than the nozzle.
    [[nodiscard]] bool of_layer(Role role, double share) const {
        return values_.width_is_of_layer() && !(values_.slicer() == Slicer::unknown && share * layer(role) < wide());
    }
    [[nodiscard]] double layer(Role role) const {
        const double usual = values_.number_or("layer_height", 0.2);
        const char* first = "first_layer_height";
        if (role != kFirst || values_.text(first).empty()) return usual;
        return values_.percent(first) ? values_.number(first) / 100 * usual : values_.number(first);
    }
    // A percentage in mm, without rounding errors.
    [[nodiscard]] double of_percentage(Role role, const std::string& key) const {
        const double share = values_.number(key) / 100;
        return std::round(share * (of_layer(role, share) ? layer(role) : wide()) * 1e6) / 1e6;
    }

    // The width of the role in mm; 0: unknown, or, of the first layer, as on other layers.
    [[nodiscard]] double width(Role role) const {
        if (const std::string key = source(role); !key.empty())
            return values_.percent(key) ? std::max(of_percentage(role, key), wide()) : values_.number(key);
        if (role == kFirst) return 0;
        const bool chosen = values_.slicer() != Slicer::unknown && !general_key().empty() && !kTable[role].as_nozzle;
        return std::round((chosen ? kOwnChoice : 1) * nozzle_ * 1e6) / 1e6;
    }

    // Whether the role needs an option.
    [[nodiscard]] bool wanted(Role role) const {
        const bool mixed =
            roles_.sparse && (mm_[kInner] != mm_[kOuter] || mm_[kInfill] != mm_[kInner] || mm_[kSolid] != mm_[kInner]);
        switch (role) {
        case kOuter:
            return true;
        case kInner:
            return roles_.sparse && mm_[kInner] != mm_[kOuter];
        case kInfill:
        case kSolid:
            return roles_.sparse && mm_[role] != mm_[kInner];
        case kSupport:
            return roles_.supports && mm_[kSupport] != mm_[kOuter];
        case kFirst:
            return mixed || mm_[kFirst] != mm_[kOuter];
        default:
            return false;
        }
    }

    void tell_percentage(Role role) {
        const std::string key = source(role);
        if (key.empty() || !values_.percent(key)) return;
        const double mm = of_percentage(role, key);
        remarks_.push_back(key + " = " + values_.text(key) + " taken of the " +
                           (of_layer(role, values_.number(key) / 100) ? "layer height" : "nozzle") + ", as " +
                           (values_.slicer() == Slicer::unknown ? "SuperSlicer" : name_of(values_.slicer())) +
                           " does: " + shortest_text(std::max(mm, wide())) + " mm" +
                           (mm < wide() ? ", the nozzle's width, since " + shortest_text(mm) + " mm is less" : ""));
    }

    void tell_top() {
        const double used = mm_[roles_.sparse ? kSolid : kOuter];
        if (own_key(kTop).empty() || mm_[kTop] == used) return;
        remarks_.push_back(own_key(kTop) + " = " + values_.text(own_key(kTop)) + " (" + shortest_text(mm_[kTop]) +
                           " mm): beads of top surfaces are as wide as those of other solid areas, " +
                           shortest_text(used) + " mm");
    }

    const SlicerValues& values_;
    WidthRoles roles_;
    Words& remarks_;
    double nozzle_; // mm; 0: unknown
    std::array<double, kRoles> mm_{};
};

} // namespace

Words width_words(const SlicerValues& values, const std::string& key, const WidthRoles& roles, Words& remarks) {
    return RoleWidths(values, roles, remarks).words(key);
}

} // namespace filum::app::filum
