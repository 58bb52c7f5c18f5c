#include "figures/figure.h"

#include <fmt/format.h>

#include <array>
#include <cstddef>

#include "figures/make_figures.h"

namespace stridegraph::figures {
namespace {

constexpr std::string_view kPageStyle = R"(
:root { color-scheme: light dark; }
body { margin: 0 auto; max-width: 76rem; padding: 1.5rem; font: 16px/1.5 Inter, system-ui, sans-serif;
       background: light-dark(#e9edf2, #161a21); color: light-dark(#1a2433, #e8edf5); }
h1 { margin-bottom: 0; } h2 { margin-top: 3rem; }
nav a { margin-right: 1.2rem; white-space: nowrap; } a { color: light-dark(#2563d9, #6aa5ff); }
figure { margin: 1.5rem 0 2.5rem; } img { max-width: 100%; height: auto; display: block; }
figcaption { margin-top: .6rem; max-width: 48rem; }
)";

std::string anchorOf(std::size_t section) {
  return fmt::format("part{}", section + 1);
}

std::string figureElement(const Figure& figure) {
  return fmt::format(
      "<figure id=\"{0}\">\n<a href=\"{0}.svg\"><img src=\"{0}.svg\" width=\"{1}\" height=\"{2}\" "
      "alt=\"{3}\"/></a>\n<figcaption>{3}</figcaption>\n</figure>\n",
      escapeXml(figure.name), pixels(figure.svg.width()), pixels(figure.svg.height()),
      escapeXml(figure.caption));
}

std::string folderElement(const FigureFolder& folder) {
  const std::string name = escapeXml(folder.name);
  std::string html = fmt::format("<h2 id=\"{0}\">{0}</h2>\n", name);
  if (folder.hasIndex)
    return html + fmt::format("<p><a href=\"{0}/index.html\">The same from {0}</a></p>\n", name);
  if (!folder.table.empty()) html += fmt::format("<pre>{}</pre>\n", escapeXml(folder.table));
  for (const std::string& picture : folder.pictures) {
    html += fmt::format(
        "<figure>\n<img src=\"{0}/{1}.svg\" alt=\"{1}\"/>\n<figcaption>{1}</figcaption>\n</figure>\n", name,
        escapeXml(picture));
  }
  return html;
}

}  // namespace

std::string fileNameFrom(std::string_view name) {
  std::string file;
  for (const char c : name) {
    const bool plain = (c >= 'a' && c <= 'z') || (c >= '0' && c <= '9');
    const bool capital = c >= 'A' && c <= 'Z';
    file += plain ? c : (capital ? static_cast<char>(c - 'A' + 'a') : '_');
  }
  return file;
}

std::vector<FigureSection> makeFigures(const FigureInputs& inputs,
                                       const std::function<void(double)>& progress) {
  struct Stage {
    const char* title;
    std::vector<Figure> (*draw)(const FigureInputs&);
  };
  constexpr std::array<Stage, 11> kStages = {{{"A planned walk", stripFigures},
                                              {"Clips", poseFigures},
                                              {"Feet", footFigures},
                                              {"Likeness of clips", similarityFigures},
                                              {"Transitions", rootPathFigures},
                                              {"Motion graph", graphFigures},
                                              {"Paths", pathFigures},
                                              {"Walks", walkFigures},
                                              {"Two searches", searchFigures},
                                              {"Clean feet", footCleanupFigures},
                                              {"Arrival", arrivalFigures}}};
  std::vector<FigureSection> sections;
  for (std::size_t i = 0; i < kStages.size(); ++i) {
    progress(static_cast<double>(i) / static_cast<double>(kStages.size()));
    std::vector<Figure> figures = kStages.at(i).draw(inputs);
    if (!figures.empty()) sections.push_back({kStages.at(i).title, std::move(figures)});
  }
  return sections;
}

std::vector<FigureSection> makeFigures(const FigureInputs& inputs) {
  return makeFigures(inputs, [](double) {});
}

std::string indexPage(const std::vector<FigureSection>& sections, const std::vector<FigureFolder>& folders,
                      const std::string& about) {
  std::string links;
  std::string body;
  for (std::size_t s = 0; s < sections.size(); ++s) {
    const std::string title = escapeXml(sections[s].title);
    links += fmt::format("<a href=\"#{}\">{}</a>\n", anchorOf(s), title);
    body += fmt::format("<h2 id=\"{}\">{}</h2>\n", anchorOf(s), title);
    for (const Figure& figure : sections[s].figures) body += figureElement(figure);
  }
  for (const FigureFolder& folder : folders) {
    links += fmt::format("<a href=\"#{0}\">{0}</a>\n", escapeXml(folder.name));
    body += folderElement(folder);
  }
  return fmt::format(
      "<!DOCTYPE html>\n<html lang=\"en\" xmlns=\"http://www.w3.org/1999/xhtml\">\n<head>\n"
      "<meta charset=\"utf-8\"/>\n<meta name=\"viewport\" content=\"width=device-width\"/>\n"
      "<title>Stridegraph: every stage in pictures</title>\n<style>{}</style>\n</head>\n<body>\n"
      "<h1>Every stage in pictures</h1>\n<p>{}</p>\n<nav>\n{}</nav>\n{}</body>\n</html>\n",
      kPageStyle, escapeXml(about), links, body);
}

}  // namespace stridegraph::figures
