#include "answers.h"

#include <sys/random.h>

#include <array>
#include <charconv>

#include "rectilin/base/printable.h"

namespace rectilin::serve {

Response json_response(const Json& json, int status) {
  return {status, "application/json", to_bytes(to_text(json)), {{"Cache-Control", "no-store"}}};
}

Response error_response(int status, const std::string& why) {
  return json_response(Json{{"error", printable(why)}}, status);
}

std::uint64_t number_argument(const Request& request, const std::string& name, std::uint64_t otherwise,
                              std::uint64_t least, std::uint64_t most) {
  const auto text = request.argument(name);
  if (!text) return otherwise;
  std::uint64_t x = 0;
  const auto [end, error] = std::from_chars(text->data(), text->data() + text->size(), x);
  if (error != std::errc() || end != text->data() + text->size() || x < least || x > most)
    throw Refusal(400, name + " is not a whole number from " + std::to_string(least) + " to " + std::to_string(most));
  return x;
}

std::string needed_argument(const Request& request, const std::string& name) {
  const auto text = request.argument(name);
  if (!text || text->empty()) throw Refusal(400, "the argument '" + name + "' is missing");
  return *text;
}

std::string random_name() {
  std::array<unsigned char, 16> bytes{};
  if (getrandom(bytes.data(), bytes.size(), 0) != static_cast<ssize_t>(bytes.size()))
    throw std::runtime_error("no random numbers");
  std::string name;
  for (const unsigned char b : bytes) {
    constexpr char kDigits[] = "0123456789abcdef";
    name += kDigits[b >> 4];
    name += kDigits[b & 15];
  }
  return name;
}

}  // namespace rectilin::serve
