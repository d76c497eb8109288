// GET /api/v1/authority: the certificate of the authority that has signed for this server, as a file that a phone
// installs; for everybody, as who does not trust the server yet needs it.
#include "server/handlers/authority_certificate.h"
#include "server/handlers/handlers.h"

namespace race::server {

Handled get_authority(const Request&, AuthorityCertificate& authority) {
  if (authority.certificate.empty())
    return failed({ErrorCode::not_found, "this server serves no network and has no authority"});
  Reply reply;
  reply.text = authority.certificate;
  reply.type = "application/x-x509-ca-cert";
  reply.headers.emplace_back("Content-Disposition", "attachment; filename=\"race-authority.crt\"");
  reply.headers.emplace_back("X-Fingerprint-SHA256", authority.fingerprint);
  return reply;
}

}  // namespace race::server
