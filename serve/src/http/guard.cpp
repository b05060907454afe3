#include "http/guard.h"

#include <arpa/inet.h>

#include <algorithm>

#include "rectilin/base/parameters.h"

namespace rectilin::serve {
namespace {

std::string in_small_letters(std::string text) {
  std::ranges::transform(text, text.begin(),
                         [](char c) { return 'A' <= c && c <= 'Z' ? static_cast<char>(c + 32) : c; });
  return text;
}

bool is_number_address(const std::string& host) {
  in6_addr address{};
  return inet_pton(AF_INET, host.c_str(), &address) == 1 || inet_pton(AF_INET6, host.c_str(), &address) == 1;
}

Response forbidden(const std::string& why) {
  return {403, "application/json", to_bytes(to_text(Json{{"error", why}}))};
}

}  // namespace

bool is_own_host(const std::string& host, const std::vector<std::string>& names) {
  std::string name, rest;
  if (host.starts_with('[')) {
    const std::size_t end = host.find(']');
    if (end == std::string::npos) return false;
    name = host.substr(1, end - 1);
    rest = host.substr(end + 1);
  } else {
    const std::size_t colon = std::min(host.find(':'), host.size());
    name = host.substr(0, colon);
    rest = host.substr(colon);
  }
  const bool port =
      rest.empty() || (rest[0] == ':' && rest.size() <= 6 &&
                       std::all_of(rest.begin() + 1, rest.end(), [](char c) { return '0' <= c && c <= '9'; }));
  if (!port) return false;
  name = in_small_letters(name);
  return name == "localhost" || is_number_address(name) ||
         std::ranges::any_of(names, [&](const std::string& own) { return in_small_letters(own) == name; });
}

std::optional<Response> refused_by_guard(const Request& request, const std::vector<std::string>& names) {
  const std::string host = request.header("host");
  if (!is_own_host(host, names))
    return forbidden("this server does not go by that name; start it with --host NAME if it should");
  const bool page = request.path == "/";  // a link from elsewhere to the page itself does no harm
  if (const std::string site = request.header("sec-fetch-site"); !page && (site == "cross-site" || site == "same-site"))
    return forbidden("another site asks");
  // Browsers send Origin with every POST; other programs send none.
  if (const auto origin = request.headers.find("origin");
      origin != request.headers.end() && in_small_letters(origin->second) != in_small_letters("http://" + host))
    return forbidden("another site asks");
  return std::nullopt;
}

const std::vector<std::pair<std::string, std::string>>& guarding_headers() {
  static const std::vector<std::pair<std::string, std::string>> headers{
      {"Content-Security-Policy",
       "default-src 'none'; script-src 'self'; style-src 'self'; img-src 'self'; connect-src 'self'; "
       "base-uri 'none'; form-action 'none'; frame-ancestors 'none'"},
      {"Cross-Origin-Opener-Policy", "same-origin"},
      {"Cross-Origin-Resource-Policy", "same-origin"},
      {"Referrer-Policy", "no-referrer"},
      {"X-Content-Type-Options", "nosniff"},
  };
  return headers;
}

}  // namespace rectilin::serve
