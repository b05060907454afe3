#include "rectilin/search/page.h"

#include <tbb/parallel_for.h>

#include <map>

#include "rectilin/mesh/source.h"
#include "rectilin/render/thumbnail.h"
#include "rectilin/report/contact_sheet.h"
#include "rectilin/report/html.h"
#include "rectilin/retrieval/model.h"

namespace rectilin::search {

namespace html = report::html;

std::string picture_page(const std::string& title, const std::string& text, const std::vector<PageSection>& sections) {
  std::map<std::string, std::string> pictures;
  for (const PageSection& section : sections)
    for (const PictureOf& p : section.pictures)
      if (p.png.empty()) pictures.emplace(p.source, "");
  std::vector<std::pair<const std::string, std::string>*> list;
  for (auto& entry : pictures) list.push_back(&entry);
  tbb::parallel_for(std::size_t{0}, list.size(), [&](std::size_t i) {
    try {
      const retrieval::Model model(load_mesh(list[i]->first).mesh);
      list[i]->second = render::thumbnail(model.posed("rectilinear"), render::Up::kZ);
    } catch (const std::exception&) {  // it was moved since, or is damaged: the name alone is shown
    }
  });
  std::string body = html::paragraph(html::escape(text));
  for (const PageSection& section : sections) {
    body += html::heading(section.title);
    // One sheet each, which a row holds as many of as the screen has room for.
    body += "<div style=\"display:flex;flex-wrap:wrap;gap:4px\">\n";
    for (const PictureOf& p : section.pictures) {
      const report::ContactSheet sheet =
          report::contact_sheet({{p.png.empty() ? pictures[p.source] : p.png, p.name, p.value}}, 1);
      body += "<div style=\"width:" + std::to_string(sheet.width) + "px\" title=\"" + html::escape(p.name) + "\">" +
              sheet.svg + "</div>\n";
    }
    body += "</div>\n";
  }
  return html::page(title, body);
}

}  // namespace rectilin::search
