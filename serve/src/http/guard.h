// Keeps other web sites from using the server through the browser of somebody who may.
#pragma once

#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "http/message.h"

namespace rectilin::serve {

/// Whether the server goes by the name in a Host header, "NAME" or "NAME:PORT": any address of numbers, localhost, or
/// one of `names`. A site that has its own name lead to this machine (DNS rebinding) arrives with that name.
bool is_own_host(const std::string& host, const std::vector<std::string>& names);

/// Why a request is refused, 403 or 400: another site's name, or a browser that says that another site's page asks.
std::optional<Response> refused_by_guard(const Request& request, const std::vector<std::string>& names);

/// The headers of every response: nothing but the server's own files may run, be shown or be asked for by its pages.
const std::vector<std::pair<std::string, std::string>>& guarding_headers();

}  // namespace rectilin::serve
