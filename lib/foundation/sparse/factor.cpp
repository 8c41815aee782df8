#include "sparse/factor.hpp"

#include "base/error.hpp"

#include <suitesparse/cholmod.h>

// A function of GCC's OpenMP runtime, which CHOLMOD uses. clang's omp.h would add a second runtime.
extern "C" void omp_set_max_active_levels(int);

namespace filum::sparse {

namespace {

// Limits OpenMP to the calling thread. CHOLMOD starts four threads with any setting, and they mostly wait.
void by_one_thread() { omp_set_max_active_levels(0); }

// A view of the matrix for CHOLMOD, without a copy.
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
    // The CHOLMOD workspace, shared by all factors from one analysis.
    struct Workspace {
        cholmod_common common;
        Workspace() {
            cholmod_start(&common);
            common.print = 0;
            common.supernodal = CHOLMOD_AUTO; // CHOLMOD decides by its estimate of what supernodes save
            // Without it, a matrix that is not positive definite would be accepted without supernodes.
            common.final_ll = 1;
            common.nmethods = 1; // AMD only: nested dissection takes twice as long on surfaces, and threads would race
            common.method[0].ordering = CHOLMOD_AMD;
            common.postorder = 1;
        }
        ~Workspace() { cholmod_finish(&common); }
        Workspace(const Workspace&) = delete;
        Workspace& operator=(const Workspace&) = delete;
    };

    std::shared_ptr<Workspace> workspace = std::make_shared<Workspace>();
    cholmod_factor* factor = nullptr;

    ~State() {
        if (factor != nullptr) cholmod_free_factor(&factor, &workspace->common);
    }
};

Factor::Factor() : state_(std::make_unique<State>()) {}
Factor::~Factor() = default;
Factor::Factor(Factor&&) noexcept = default;
Factor& Factor::operator=(Factor&&) noexcept = default;

void Factor::analyse(const Matrix& a) {
    by_one_thread();
    cholmod_sparse m = view(a);
    state_->factor = cholmod_analyze(&m, &state_->workspace->common);
    if (state_->factor == nullptr) throw Error(Exit::failure, "cannot factorise the surface's matrix: out of memory");
}

Factor Factor::same_order() const {
    Factor out;
    out.state_->workspace = state_->workspace;
    out.state_->factor = cholmod_copy_factor(state_->factor, &state_->workspace->common);
    return out;
}

bool Factor::factorise(const Matrix& a) {
    by_one_thread();
    cholmod_sparse m = view(a);
    cholmod_common& common = state_->workspace->common;
    cholmod_factorize(&m, state_->factor, &common);
    if (common.status == CHOLMOD_OUT_OF_MEMORY)
        throw Error(Exit::failure, "cannot factorise the surface's matrix: out of memory");
    return common.status == CHOLMOD_OK;
}

Eigen::VectorXd Factor::solve(const Eigen::VectorXd& b) const {
    by_one_thread();
    cholmod_dense right{};
    right.nrow = right.d = right.nzmax = static_cast<std::size_t>(b.size());
    right.ncol = 1;
    right.x = const_cast<double*>(b.data());
    right.xtype = CHOLMOD_REAL;
    right.dtype = CHOLMOD_DOUBLE;
    cholmod_common& common = state_->workspace->common;
    cholmod_dense* x = cholmod_solve(CHOLMOD_A, state_->factor, &right, &common);
    if (x == nullptr) throw Error(Exit::failure, "cannot solve on the surface: out of memory");
    Eigen::VectorXd out = Eigen::Map<Eigen::VectorXd>(static_cast<double*>(x->x), b.size());
    cholmod_free_dense(&x, &common);
    return out;
}

} // namespace filum::sparse
