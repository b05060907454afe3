#include "rectilin/base/printable.h"
#include "support/catch.h"

using namespace rectilin;
using namespace std::string_literals;

TEST_CASE("usual text stays as it is", "[printable]") {
  for (const char* text :
       {"", "chair.off", "a b 'c' \"d\" \\ % @NAME@ <&>", "Grüße", "чайник", "茶壺", "☕", "e\u0301"}) {
    CHECK(printable(text) == text);
    CHECK(is_printable(text));
  }
}

TEST_CASE("what is not seen is made visible, in one line", "[printable]") {
  CHECK(printable("a\nb\tc\r") == "a\\nb\\tc\\r");
  CHECK(printable("\x1B[31m\x7F\0"s) == "\\x1B[31m\\x7F\\x00");
  CHECK(printable("\xFFn\xC3") == "\\xFFn\\xC3");
  CHECK(printable("\xC0\xAF") == "\\xC0\\xAF");                    // overlong
  CHECK(printable("\xED\xA0\x80") == "\\xED\\xA0\\x80");           // a surrogate
  CHECK(printable("\xF4\x90\x80\x80") == "\\xF4\\x90\\x80\\x80");  // above U+10FFFF
  CHECK(printable("\u0085\u2028\u202E\uFFFE") == "\\u{85}\\u{2028}\\u{202E}\\u{FFFE}");
  for (int byte = 0; byte < 256; ++byte) {
    const std::string shown = printable(std::string("a") + static_cast<char>(byte) + "b");
    CHECK(printable(shown) == shown);
    CHECK(shown.find('\n') == std::string::npos);
  }
}

TEST_CASE("columns of a terminal", "[printable]") {
  CHECK(width("abc") == 3);
  CHECK(width("чайник") == 6);
  CHECK(width("茶壺") == 4);
  CHECK(width("e\u0301") == 1);
}

TEST_CASE("text is cut between characters", "[printable]") {
  CHECK(shortened("short", 10) == "short");
  CHECK(shortened("abcdefghijklmnop", 10) == "abcdef..op");
  CHECK(shortened_to_end("abcdefghijklmnop", 10) == "..ijklmnop");
  std::string text;
  for (int i = 0; i < 30; ++i) {
    text += i % 3 == 0 ? "ü" : i % 3 == 1 ? "茶" : "e\u0301";
    for (std::size_t columns = 5; columns < 45; ++columns) {
      for (const std::string& cut : {shortened(text, columns), shortened_to_end(text, columns)}) {
        CHECK(is_printable(cut));
        CHECK(width(cut) <= columns);
        CHECK_FALSE(cut.ends_with("..\u0301"));
      }
    }
  }
}
