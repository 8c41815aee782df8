#include "sequence/cover.hpp"

#include <glpk.h>

#include <algorithm>
#include <cmath>

namespace filum::sequence {

namespace {
constexpr std::uint64_t kPivot = 8; // steps of a pivot per row and column
// By how much less the highest link costs than the lowest in a first solution. Any small number does: it decides
// between solutions of nearly the same value.
constexpr double kHigher = 0.01;
} // namespace

Index proven_unused(std::size_t links, const std::vector<Inequality>& cuts, std::span<const double> prices) {
    constexpr std::int64_t kOne = std::int64_t{1} << 24; // the unit of prices
    std::int64_t sum = 0;
    std::vector<std::int64_t> over(links, -kOne);
    for (std::size_t i = 0; i < cuts.size(); ++i) {
        const double price = std::clamp(prices[i], 0.0, 1e3); // other values would be as valid as any price
        const auto whole = static_cast<std::int64_t>(std::nearbyint(price * static_cast<double>(kOne)));
        sum += whole * cuts[i].least;
        for (const Index a : cuts[i].link) over[a] += whole;
    }
    for (const std::int64_t o : over) sum -= std::max<std::int64_t>(0, o);
    return sum <= 0 ? 0 : static_cast<Index>((sum + kOne - 1) / kOne);
}

struct Cover::Program {
    glp_prob* lp;
    std::vector<Inequality> cuts; // row i + 1 each
    std::vector<double> unused;
    std::uint64_t work = 0;
    bool exact = false;

    explicit Program(std::size_t links) : lp(glp_create_prob()), unused(links, 0) {
        glp_set_obj_dir(lp, GLP_MIN);
        if (links > 0) glp_add_cols(lp, static_cast<int>(links));
        for (int a = 1; a <= static_cast<int>(links); ++a) glp_set_col_bnds(lp, a, GLP_DB, 0, 1);
        price(kHigher);
    }
    // Sets the costs of unused links: 1 for the lowest, `higher` less for the highest.
    void price(double higher) const {
        for (int a = 1; a <= static_cast<int>(unused.size()); ++a)
            glp_set_obj_coef(lp, a, 1 - higher * a / static_cast<double>(unused.size()));
    }
    [[nodiscard]] std::vector<double> prices() const;
    ~Program() { glp_delete_prob(lp); }
    Program(const Program&) = delete;
    Program& operator=(const Program&) = delete;
};

Cover::Cover(std::size_t links) : p_(std::make_unique<Program>(links)) {}
Cover::~Cover() = default;

const std::vector<double>& Cover::unused() const { return p_->unused; }
std::uint64_t Cover::work() const { return p_->work; }
bool Cover::is_exact() const { return p_->exact; }

void Cover::make_exact() {
    p_->exact = true;
    p_->price(0);
}

void Cover::add(std::vector<Inequality> cuts) {
    if (cuts.empty()) return;
    int row = glp_add_rows(p_->lp, static_cast<int>(cuts.size()));
    std::vector<int> column;
    std::vector<double> value;
    for (Inequality& c : cuts) {
        column.assign(1, 0); // GLPK counts from 1
        for (const Index a : c.link) column.push_back(static_cast<int>(a) + 1);
        value.assign(column.size(), 1);
        glp_set_mat_row(p_->lp, row, static_cast<int>(c.link.size()), column.data(), value.data());
        glp_set_row_bnds(p_->lp, row++, GLP_LO, c.least, 0);
        p_->cuts.push_back(std::move(c));
    }
}

bool Cover::solve(std::uint64_t budget) {
    const std::uint64_t pivot = kPivot * (p_->cuts.size() + p_->unused.size());
    glp_smcp how;
    glp_init_smcp(&how);
    how.msg_lev = GLP_MSG_OFF;
    how.meth = GLP_DUAL;
    how.it_lim = static_cast<int>(std::min<std::uint64_t>(budget / (pivot + 1) + 1, 1U << 30));
    const int before = glp_get_it_cnt(p_->lp);
    const int fault = glp_simplex(p_->lp, &how);
    const auto pivots = static_cast<std::uint64_t>(glp_get_it_cnt(p_->lp) - before);
    p_->work += (pivots + 1) * pivot;
    for (std::size_t a = 0; a < p_->unused.size(); ++a)
        p_->unused[a] = glp_get_col_prim(p_->lp, static_cast<int>(a) + 1);
    return fault == 0 && glp_get_status(p_->lp) == GLP_OPT;
}

std::vector<double> Cover::Program::prices() const {
    std::vector<double> out;
    for (std::size_t i = 0; i < cuts.size(); ++i) out.push_back(glp_get_row_dual(lp, static_cast<int>(i) + 1));
    return out;
}

Index Cover::proven() const { return proven_unused(p_->unused.size(), p_->cuts, p_->prices()); }

std::vector<double> Cover::density() const {
    std::vector<double> out(p_->unused.size(), 0);
    const auto prices = p_->prices();
    for (std::size_t i = 0; i < p_->cuts.size(); ++i) {
        const Inequality& c = p_->cuts[i];
        for (const Index a : c.link) out[a] += std::max(0.0, prices[i]) * c.least / static_cast<double>(c.link.size());
    }
    return out;
}

void Cover::forget_slack() {
    constexpr double kSpare = 0.3;
    std::vector<int> rows{0};
    std::vector<Inequality> kept;
    for (std::size_t i = 0; i < p_->cuts.size(); ++i) {
        const int row = static_cast<int>(i) + 1;
        if (glp_get_row_stat(p_->lp, row) == GLP_BS && glp_get_row_prim(p_->lp, row) > p_->cuts[i].least + kSpare)
            rows.push_back(row);
        else
            kept.push_back(std::move(p_->cuts[i]));
    }
    if (rows.size() > 1) glp_del_rows(p_->lp, static_cast<int>(rows.size()) - 1, rows.data());
    p_->cuts = std::move(kept);
}

} // namespace filum::sequence
