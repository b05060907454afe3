#include "rectilin/report/html.h"

#include <algorithm>

#include "rectilin/base/printable.h"

namespace rectilin::report::html {
namespace {

constexpr const char* kStyle = R"(
:root { color-scheme: light; }
body { max-width: 68rem; margin: 0 auto; padding: 0 1rem 4rem; color: #1a1a1a; background: #fff;
  font: 16px/1.5 system-ui, -apple-system, "Segoe UI", Roboto, "DejaVu Sans", sans-serif; }
h1 { font-size: 1.6rem; line-height: 1.2; margin: 1.5rem 0 .5rem; }
h2 { font-size: 1.25rem; margin: 2.5rem 0 .5rem; padding-top: .5rem; border-top: 1px solid #ddd; }
h3 { font-size: 1.05rem; margin: 2rem 0 .25rem; overflow-wrap: anywhere; }
p, figcaption, li { max-width: 46rem; overflow-wrap: break-word; }
.scroll { overflow-x: auto; margin: .75rem 0; }
table { border-collapse: separate; border-spacing: 0; font-size: .875rem; font-variant-numeric: tabular-nums; }
th, td { padding: .2rem .6rem; text-align: right; white-space: nowrap; border-bottom: 1px solid #e6e6e6; }
th { border-bottom: 2px solid #888; }
th:first-child, td:first-child { text-align: left; padding-left: 0; }
.number { white-space: nowrap; }
.line { width: 28px; height: 9px; margin-right: .5em; vertical-align: middle; }
.best { font-weight: 700; }
.none { color: #767676; }
figure { margin: .75rem 0; }
figure img { display: block; width: 100%; height: auto; }
figure.wide { overflow-x: auto; }
figcaption { font-size: .875rem; color: #444; }
.pair { display: grid; grid-template-columns: repeat(auto-fit, minmax(min(100%, 25rem), 1fr)); gap: 0 1.5rem; }
summary { cursor: pointer; color: #0050a0; margin: .5rem 0; }
a { color: #0050a0; }
pre { overflow-x: auto; background: #f5f5f5; padding: .75rem; font-size: .8rem; }
@media screen and (max-width: 40rem) {
  ul { padding-left: 1.2rem; }
  th, td { padding: .2rem .4rem; }
  th:first-child, td:first-child { position: sticky; left: 0; background: #fff; min-width: 8rem; max-width: 9.5rem;
    white-space: normal; overflow-wrap: anywhere; }
  .line { width: 16px; margin-right: .3em; }
}
@media print {
  body { max-width: none; font-size: 10pt; padding: 0; }
  h2, h3, summary { break-after: avoid; }
  figure, tr { break-inside: avoid; }
  h2, h3, h2 + p { break-after: avoid; }
  .scroll, figure.wide { overflow: visible; }
  figure.wide img { min-width: 0 !important; max-width: 15cm !important; }
  .pair { grid-template-columns: 1fr 1fr; }
  table { font-size: 7.5pt; }
  th, td { padding: .1rem .3rem; }
  th, td:first-child { white-space: normal; }
  pre { columns: 3; font-size: 5.5pt; white-space: pre-wrap; overflow-wrap: anywhere; background: none; padding: 0; }
}
)";

constexpr const char* kOpenForPrint =
    "addEventListener('beforeprint', () => document.querySelectorAll('details').forEach(d => d.open = true));";

std::string cells(const std::vector<std::string>& contents, const std::string& tag) {
  std::string row = "<tr>";
  for (const std::string& content : contents) row += "<" + tag + ">" + content + "</" + tag + ">";
  return row + "</tr>\n";
}

}  // namespace

std::string escape(std::string_view text) {
  std::string result;
  for (const char c : printable(text)) {
    switch (c) {
      case '&':
        result += "&amp;";
        break;
      case '<':
        result += "&lt;";
        break;
      case '>':
        result += "&gt;";
        break;
      case '"':
        result += "&quot;";
        break;
      case '\'':
        result += "&#39;";
        break;
      default:
        result += c;
    }
  }
  return result;
}

std::string escape_lines(std::string_view text) {
  std::string result;
  while (!text.empty()) {
    const std::size_t size = std::min(text.find('\n'), text.size());
    result += escape(text.substr(0, size));
    text.remove_prefix(size);
    if (text.empty()) break;
    result += '\n';
    text.remove_prefix(1);
  }
  return result;
}

Table::Table(const std::vector<std::string>& header) : rows_("<thead>" + cells(header, "th") + "</thead><tbody>\n") {}

Table& Table::row(const std::vector<std::string>& contents) {
  rows_ += cells(contents, "td");
  return *this;
}

std::string Table::text() const { return "<div class=\"scroll\"><table>" + rows_ + "</tbody></table></div>\n"; }

std::string heading(const std::string& text) { return "<h2>" + escape(text) + "</h2>\n"; }
std::string paragraph(const std::string& html) { return "<p>" + html + "</p>\n"; }
std::string details(const std::string& summary, const std::string& html) {
  return "<details><summary>" + escape(summary) + "</summary>\n" + html + "</details>\n";
}
std::string link(const std::string& target, const std::string& text) {
  return "<a href=\"" + escape(target) + "\">" + escape(text) + "</a>";
}

std::string picture(const std::string& svg, const std::string& caption, const std::string& more, int width) {
  constexpr int kFitsPhones = 560;  // at half its size the text is still legible
  const bool wide = width > kFitsPhones;
  const std::string style = "max-width:" + std::to_string(width * 6 / 5) + "px" +
                            (wide ? ";min-width:" + std::to_string(width * 4 / 5) + "px" : "");
  return std::string("<figure") + (wide ? " class=\"wide\"" : "") + "><a href=\"" + escape(svg) + "\"><img style=\"" +
         style + "\" src=\"" + escape(svg) + "\" alt=\"" + escape(caption) + "\"></a><figcaption>" + escape(caption) +
         " " + more + "</figcaption></figure>\n";
}

std::string side_by_side(const std::string& html) { return "<div class=\"pair\">\n" + html + "</div>\n"; }

std::string page(const std::string& title, const std::string& body) {
  return "<!DOCTYPE html>\n"
         "<html lang=\"en\">\n"
         "<head>\n"
         "<meta charset=\"utf-8\">\n"
         "<meta name=\"viewport\" content=\"width=device-width, initial-scale=1\">\n<title>" +
         escape(title) + "</title>\n<style>" + kStyle + "</style>\n</head>\n<body>\n<h1>" + escape(title) + "</h1>\n" +
         body + "<script>" + kOpenForPrint + "</script>\n</body>\n</html>\n";
}

}  // namespace rectilin::report::html
