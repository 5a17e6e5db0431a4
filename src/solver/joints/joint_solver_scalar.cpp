// The joint solver for one lane: the reference that wider lanes are tested against.
#include "solver/joints/joint_solver_impl.hpp"

namespace carom::detail
{

template class JointSolver<float>;

} // namespace carom::detail
