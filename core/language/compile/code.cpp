#include "core/language/compile/code.h"

#include "core/language/compile/program.h"

namespace race::language {

CodeKind Code::kind() const { return program_->kind; }
const std::string& Code::text() const { return program_->text; }
const Mentions& Code::mentions() const { return program_->mentions; }

}  // namespace race::language
