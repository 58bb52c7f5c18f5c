#pragma once

#include <memory>
#include <string>
#include <string_view>
#include <vector>

#include "figures/svg.h"
#include "graph/library.h"
#include "scene/scene.h"
#include "walk/walk_planner.h"

namespace stridegraph::figures {

/// A picture with what is said of it.
struct Figure {
  std::string name;     ///< Of its file, without ".svg".
  std::string caption;  ///< What one should see, in a sentence or two.
  Svg svg;
};

/// A name for a file: letters and figures in lower case, all else an underscore.
std::string fileNameFrom(std::string_view name);

/// What pictures are made of.
struct FigureInputs {
  std::shared_ptr<const WalkPlanner> planner;
  std::vector<Scene> scenes;

  const MotionLibrary& library() const { return planner->library(); }
};

/// The stages, in the order of the data flow: each gives its pictures, none where the library or the scenes
/// have nothing for it. The same inputs give the same pictures, byte for byte.
std::vector<Figure> poseFigures(const FigureInputs& inputs);
std::vector<Figure> similarityFigures(const FigureInputs& inputs);
std::vector<Figure> rootPathFigures(const FigureInputs& inputs);
std::vector<Figure> graphFigures(const FigureInputs& inputs);
std::vector<Figure> pathFigures(const FigureInputs& inputs);
std::vector<Figure> walkFigures(const FigureInputs& inputs);
std::vector<Figure> searchFigures(const FigureInputs& inputs);
std::vector<Figure> footFigures(const FigureInputs& inputs);
std::vector<Figure> footCleanupFigures(const FigureInputs& inputs);
std::vector<Figure> arrivalFigures(const FigureInputs& inputs);
std::vector<Figure> stripFigures(const FigureInputs& inputs);

/// A heading and the pictures under it.
struct FigureSection {
  std::string title;
  std::vector<Figure> figures;
};

/// All of them.
std::vector<FigureSection> makeFigures(const FigureInputs& inputs);

/// A folder beside the pictures with some that were made elsewhere.
struct FigureFolder {
  std::string name;
  bool hasIndex = false;              ///< Has a page of its own, which is linked.
  std::vector<std::string> pictures;  ///< Names of its SVG files without ".svg"; shown where it has no page.
  std::string table;                  ///< Text to be shown as it is; may be empty.
};

/// The page that shows them, beside their files: HTML with no script.
std::string indexPage(const std::vector<FigureSection>& sections, const std::vector<FigureFolder>& folders,
                      const std::string& about);

}  // namespace stridegraph::figures
