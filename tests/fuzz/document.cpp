// Documents and descriptions of services: any text is refused with a reason, or read; what is read survives writing,
// formatting and ids, and is translated and compiled.
#include "core/rcm/document.h"

#include "core/execution/executed_model.h"
#include "core/rcm/constraints.h"
#include "core/rcm/ids.h"
#include "core/rcm/native.h"
#include "core/rcm/translate.h"
#include "core/rsm/document.h"
#include "core/value/json.h"
#include "tests/fuzz/support/expect.h"
#include "tests/fuzz/support/input.h"
#include "tests/fuzz/support/json_mutator.h"

namespace race {
namespace {

void hold_draft(std::string_view text) {
  const auto json = parse_json(text, {.keep_out_of_range = true});
  if (!json) return;
  const rcm::Draft draft = rcm::read_draft(*json);
  FUZZ_EXPECT(rcm::violations(draft).size() >= draft.errors.size());
}

// A text that is too large or too deep once ids are in it is refused.
void hold_ids(rcm::Document document) {
  rcm::give_ids(document);
  const auto text = rcm::write_document_text(document);
  if (text) FUZZ_EXPECT(rcm::read_document_text(*text).value() == document);
}

void hold_document(std::string_view text) {
  const auto document = rcm::read_document_text(text);
  if (!document) return FUZZ_EXPECT(!document.error().empty());
  FUZZ_EXPECT(rcm::violations(*document).empty());
  FUZZ_EXPECT(rcm::read_document(rcm::write_document(*document)).value() == *document);
  const std::string formatted = rcm::format_document(*document);
  if (const auto again = rcm::read_document_text(formatted)) {
    FUZZ_EXPECT(*again == *document);
    FUZZ_EXPECT(rcm::format_document(*again) == formatted);
  } else {
    FUZZ_EXPECT(!rcm::write_document_text(*document));
  }
  hold_ids(*document);
  const auto native = rcm::translate(*document);
  FUZZ_EXPECT(native);
  (void)execution::build_model(rcm::write_native(*document, *native), {}, "native");
}

void hold_service(std::string_view text) {
  const auto service = rsm::read_service_text(text, "services/s");
  if (!service) return FUZZ_EXPECT(!service.error().empty());
  FUZZ_EXPECT(rsm::read_service(rsm::write_service(*service), "services/s").value() == *service);
}

}  // namespace
}  // namespace race

FUZZ_MUTATE_WITH(race::fuzz::mutate_json)

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  const std::string_view text = race::fuzz::text_of(data, size);
  race::hold_draft(text);
  race::hold_document(text);
  race::hold_service(text);
  return 0;
}
