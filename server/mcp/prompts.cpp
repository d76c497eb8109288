#include "server/mcp/prompts.h"

#include <algorithm>
#include <array>

namespace race::server::mcp {
namespace {

// Each has one argument, which takes the place of `{}` in its text.
struct Prompt {
  std::string_view name, title, description, argument, argument_description, text;
};

constexpr std::array kPrompts = {
    Prompt{"explain_run", "Explain a run", "What a run has done, and why it ended as it did.", "run",
           "The number of the run",
           "Explain run {} of the robot cell to a person who has not watched it. Look at it with run_status, read the "
           "last macro steps with read_derivations, and ask explain_port about the ports that decided how it went. Say "
           "what happened, why, and what could be done; change and start nothing."},
    Prompt{"repair_document", "Repair a document", "Finds what is wrong in a document, and offers a repair.",
           "document", "The name of the document",
           "The document {} of the robot cell has errors. Read it with read_document, and look at each error's path, "
           "code and message. Change as little as possible, check the result with check_document until it is valid, "
           "offer it with propose_document, and say what you have changed and why. Start nothing."},
    Prompt{
        "new_task", "Make a task", "Puts a task together from skills.", "goal", "What the robot should do",
        "Make a task for the robot cell: {}. Read race://cell, the skills with list_skills and the services with "
        "list_services; read a document that is similar first. Put the task together from skills where they fit, with "
        "values within their ranges, and a way on for each error. Check it with check_document until it is valid, and "
        "offer it with propose_document. Start it only if the person asks for it: a robot may move."},
};

Value prompt_json(const Prompt& prompt) {
  return Dict{
      {"name", prompt.name},
      {"title", prompt.title},
      {"description", prompt.description},
      {"arguments",
       List{Dict{{"name", prompt.argument}, {"description", prompt.argument_description}, {"required", true}}}}};
}

constexpr std::size_t kMostArgument = std::size_t{64} * 1024;

tl::unexpected<RpcError> wrong(ErrorCode code, const std::string& path, const std::string& message) {
  return tl::unexpected(make_rpc_error(RpcCode::invalid_params, {{code, message, path}}));
}

std::string filled(std::string_view text, const std::string& argument) {
  const std::size_t place = text.find("{}");
  return std::string(text.substr(0, place)) + argument + std::string(text.substr(place + 2));
}

}  // namespace

tl::expected<Value, RpcError> list_prompts(const Context&, const Value& params) {
  if (params.find("cursor")) return wrong(ErrorCode::not_found, "cursor", "is of no list");
  List prompts;
  for (const Prompt& prompt : kPrompts) prompts.push_back(prompt_json(prompt));
  return Dict{{"prompts", std::move(prompts)}};
}

tl::expected<Value, RpcError> get_prompt(const Context&, const Value& params) {
  const Value* name = params.find("name");
  const std::string wanted = name && name->is_string() ? name->as_string() : std::string();
  const auto prompt = std::ranges::find(kPrompts, wanted, &Prompt::name);
  if (prompt == kPrompts.end()) return wrong(ErrorCode::not_found, "name", "there is no such prompt");
  const Value* arguments = params.find("arguments");
  const Value* argument = arguments ? arguments->find(prompt->argument) : nullptr;
  const std::string path = "arguments/" + std::string(prompt->argument);
  if (!argument || !argument->is_string()) return wrong(ErrorCode::missing, path, "must be there, a string");
  if (argument->as_string().size() > kMostArgument) return wrong(ErrorCode::too_large, path, "has more than 64 KiB");
  const std::string text = filled(prompt->text, argument->as_string());
  return Dict{{"description", prompt->description},
              {"messages", List{Dict{{"role", "user"}, {"content", Dict{{"type", "text"}, {"text", text}}}}}}};
}

}  // namespace race::server::mcp
