#include "sparse/factor.hpp"

#include "base/error.hpp"

#include <Eigen/SparseCholesky>
#include <mutex>
#include <suitesparse/cholmod.h>

// Of GCC's OpenMP, on which CHOLMOD runs; clang's omp.h would bring a second one.
extern "C" void omp_set_max_active_levels(int);

namespace filum::sparse {

namespace {

constexpr Eigen::Index kSupernodal = 150'000; // rows from which the overhead of supernodes pays

// CHOLMOD stands on whatever BLAS is there, and OpenBLAS built for one thread has buffers that all callers share: two
// that factorised at once got wrong numbers.  So one after the other.
std::mutex& turn() {
    static std::mutex one;
    return one;
}

// CHOLMOD takes four threads whatever it is told, and they mostly wait: none but the calling one from here on.
void by_one_thread() { omp_set_max_active_levels(0); }

// The matrix as CHOLMOD sees it, without a copy.
cholmod_sparse view(const Matrix& a) {
    cholmod_sparse out{};
    out.nrow = static_cast<std::size_t>(a.rows());
    out.ncol = static_cast<std::size_t>(a.cols());
    out.nzmax = static_cast<std::size_t>(a.nonZeros());
    out.p = const_cast<int*>(a.outerIndexPtr());
    out.i = const_cast<int*>(a.innerIndexPtr());
    out.x = const_cast<double*>(a.valuePtr());
    out.stype = -1; // the lower triangle
    out.itype = CHOLMOD_INT;
    out.xtype = CHOLMOD_REAL;
    out.dtype = CHOLMOD_DOUBLE;
    out.sorted = 1;
    out.packed = 1;
    return out;
}

} // namespace

struct Factor::State {
    // One CHOLMOD workspace, shared by the factors that come of one analysis.
    struct Workspace {
        cholmod_common common;
        Workspace() {
            cholmod_start(&common);
            common.print = 0;
            common.supernodal = CHOLMOD_SUPERNODAL;
            common.nmethods = 1; // AMD: nested dissection takes twice as long on surfaces, and threads would race
            common.method[0].ordering = CHOLMOD_AMD;
            common.postorder = 1;
        }
        ~Workspace() { cholmod_finish(&common); }
        Workspace(const Workspace&) = delete;
        Workspace& operator=(const Workspace&) = delete;
    };

    std::shared_ptr<Workspace> workspace; // of CHOLMOD; null: Eigen's
    cholmod_factor* super = nullptr;
    Eigen::SimplicialLDLT<Matrix> simple;

    ~State() {
        if (super != nullptr) cholmod_free_factor(&super, &workspace->common);
    }
};

Factor::Factor() : state_(std::make_unique<State>()) {}
Factor::~Factor() = default;
Factor::Factor(Factor&&) noexcept = default;
Factor& Factor::operator=(Factor&&) noexcept = default;

void Factor::analyse(const Matrix& a) {
    if (a.rows() <= kSupernodal) {
        state_->simple.analyzePattern(a);
        return;
    }
    state_->workspace = std::make_shared<State::Workspace>();
    by_one_thread();
    cholmod_sparse m = view(a);
    state_->super = cholmod_analyze(&m, &state_->workspace->common);
    if (state_->super == nullptr) throw Error(Exit::failure, "cannot factorise the surface's matrix: out of memory");
}

Factor Factor::same_order() const {
    Factor out;
    if (state_->workspace == nullptr) return out;
    out.state_->workspace = state_->workspace;
    out.state_->super = cholmod_copy_factor(state_->super, &state_->workspace->common);
    return out;
}

bool Factor::factorise(const Matrix& a) {
    if (state_->workspace == nullptr) {
        if (state_->simple.rows() != a.rows()) state_->simple.analyzePattern(a);
        state_->simple.factorize(a);
        return state_->simple.info() == Eigen::Success;
    }
    by_one_thread();
    const std::lock_guard lock(turn());
    cholmod_sparse m = view(a);
    cholmod_common& common = state_->workspace->common;
    cholmod_factorize(&m, state_->super, &common);
    if (common.status == CHOLMOD_OUT_OF_MEMORY)
        throw Error(Exit::failure, "cannot factorise the surface's matrix: out of memory");
    return common.status == CHOLMOD_OK;
}

Eigen::VectorXd Factor::solve(const Eigen::VectorXd& b) const {
    if (state_->workspace == nullptr) return state_->simple.solve(b);
    by_one_thread();
    cholmod_dense right{};
    right.nrow = right.d = right.nzmax = static_cast<std::size_t>(b.size());
    right.ncol = 1;
    right.x = const_cast<double*>(b.data());
    right.xtype = CHOLMOD_REAL;
    right.dtype = CHOLMOD_DOUBLE;
    cholmod_common& common = state_->workspace->common;
    const std::lock_guard lock(turn());
    cholmod_dense* x = cholmod_solve(CHOLMOD_A, state_->super, &right, &common);
    if (x == nullptr) throw Error(Exit::failure, "cannot solve on the surface: out of memory");
    Eigen::VectorXd out = Eigen::Map<Eigen::VectorXd>(static_cast<double*>(x->x), b.size());
    cholmod_free_dense(&x, &common);
    return out;
}

} // namespace filum::sparse
