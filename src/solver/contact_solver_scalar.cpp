// The contact solver in lanes of one number: the reference.
#include "solver/contact_solver_impl.hpp"

namespace carom::detail
{

template class ContactSolver<float>;

} // namespace carom::detail
