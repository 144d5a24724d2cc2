// What hangs together: when one field of an object changes, the fields that depend on it follow,
// so that a change of degree, of the number of points or of the model is one command and not three.
#pragma once

#include "scene/json.hpp"

namespace knotwork::scene {

/// The object `after`, which a command made from the canonical object `before`, with what depends
/// on the changed fields adapted:
/// knots that were the default become the new default; others are kept as far as they can be
/// (points added or removed take a knot with them, local curves keep the spacing); a domain that
/// was the default follows its parameters; weights follow the points; poses of local curves that
/// are gone go with them. Fields that were changed themselves are left as they are.
[[nodiscard]] Json adaptObject(const Json& before, Json after);

/// The object `after` with the parameters that were left as they are, `t` and that of its trace, moved
/// to the end of a domain that has shrunk.
[[nodiscard]] Json keepParameters(const Json& before, Json after);

/// A B-function specification that has just been given another family: the parameters of the
/// former family go; a family made of others takes the former function as its operand.
[[nodiscard]] Json adaptFamily(const Json& before, const std::string& family);

}  // namespace knotwork::scene
