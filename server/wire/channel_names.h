// The names of the channels of the stream, as patterns: the table of channels (server/channels) finds a channel by its
// pattern, and who publishes to one fills in the pattern.
#pragma once

#include <string_view>

namespace race::server {

inline constexpr std::string_view kCoresChannel = "cores";
inline constexpr std::string_view kServicesChannel = "services";
inline constexpr std::string_view kControlChannel = "control";
inline constexpr std::string_view kLogChannel = "log";
inline constexpr std::string_view kCellPoseChannel = "cell/pose";
inline constexpr std::string_view kDisplayChannel = "display/{name}";
inline constexpr std::string_view kFlowChannel = "flow/{service}/{flow}";
inline constexpr std::string_view kDocumentChannel = "document/{name}";
inline constexpr std::string_view kProposalsChannel = "proposals";
inline constexpr std::string_view kPresenceChannel = "presence/{name}";
inline constexpr std::string_view kCoreStateChannel = "core/{id}/state";
inline constexpr std::string_view kCoreDerivationChannel = "core/{id}/derivation";

}  // namespace race::server
