#include "walk/search_graph.h"

#include <algorithm>
#include <cmath>
#include <numeric>

#include "base/check.h"
#include "graph/jerks.h"
#include "walk/bent_step.h"
#include "walk/piece_motion.h"
#include "walk/standing.h"

namespace stridegraph {
namespace {

constexpr std::uint32_t kNone = SearchEdge::kNone;

/// A walk begins with one of so many frames: of those in motion there are more than enough,
constexpr std::uint32_t kMovingStartStride = 8;
/// of those that stand few. Who still stands there that many frames later begins then.
constexpr std::uint32_t kStandingStartStride = 2;

/// Who moves by less stands still.
constexpr double kStillMetres = 0.01;
constexpr Angle kStillTurn = Angle::degrees(1.0);

/// A way that bending would turn by less than this is there only as captured.
constexpr Angle kLeastBend = Angle::degrees(0.5);

/// A walk that begins with standing shows the body stand for so many frames more.
constexpr std::uint32_t kStandsOn = 4;

/// A piece with its track and where it leads.
struct Link {
  MotionPiece piece;
  std::vector<FloorTransform> track;
  std::uint32_t to = kNone;  ///< Node of the library's graph, or kNone behind the last node of a clip.
};

}  // namespace

class SearchGraphBuilder {
 public:
  SearchGraphBuilder(const MotionLibrary& library, const MotionLimits& limits, SearchGraph& graph)
      : library_(library),
        graph_(graph),
        standing_(standingFrames(library)),
        jerks_(findJerks(library)),
        strains_(frameStrains(library, limits)) {}

  void build() {
    STRIDEGRAPH_CHECK(!library_.graph.nodes.empty());
    addEdges();
    addRunsOut();
    findDecisions();
    for (const std::uint32_t node : decisions_) addWaysFrom(node);
    graph_.firstEdge_.push_back(static_cast<std::uint32_t>(graph_.edges_.size()));
    indexByTarget();
    for (const SearchEdge& edge : graph_.edges_) {
      graph_.canEndStanding_ = graph_.canEndStanding_ || edge.settledSample != kNone;
      graph_.fastestMetresPerFrame_ =
          std::max(graph_.fastestMetresPerFrame_, edge.lengthMetres / static_cast<double>(edge.sampleCount));
    }
    addStarts();
  }

 private:
  void addLink(const MotionPiece& piece, std::uint32_t to) {
    links_.push_back({piece, pieceTrack(library_, piece), to});
  }

  void addEdges() {
    const MotionGraph& motion = library_.graph;
    linksFrom_.resize(motion.nodes.size());
    for (const MotionEdge& edge : motion.edges) {
      linksFrom_[edge.from.value].push_back(static_cast<std::uint32_t>(links_.size()));
      addLink(pieceOf(motion, edge), edge.to.value);
      graph_.ends_.push_back(links_.back().track.back());
    }
  }

  /// Behind the last node of each clip, as far as the first frame where the body has come to a stand.
  void addRunsOut() {
    const std::vector<FrameIndex>& nodes = library_.graph.nodes;
    for (std::size_t n = 0; n < nodes.size(); ++n) {
      const LibraryClip& clip = library_.clipOf(nodes[n]);
      const std::uint32_t end = clip.firstFrame + clip.frameCount;
      if (n + 1 < nodes.size() && nodes[n + 1].value < end) continue;
      std::uint32_t settled = nodes[n].value + 1;
      while (settled < end && standing_[settled] != Standing::kSettled) ++settled;
      if (settled >= end || playsAcross(jerks_, nodes[n], FrameIndex(std::size_t{settled}))) continue;
      linksFrom_[n].push_back(static_cast<std::uint32_t>(links_.size()));
      addLink(clipPiece(nodes[n], FrameIndex(std::size_t{settled})), kNone);
    }
  }

  void findDecisions() {
    decisionOf_.assign(linksFrom_.size(), kNone);
    for (std::size_t n = 0; n < linksFrom_.size(); ++n) {
      if (linksFrom_[n].size() < 2) continue;
      decisionOf_[n] = static_cast<std::uint32_t>(decisions_.size());
      decisions_.push_back(static_cast<std::uint32_t>(n));
    }
    if (decisions_.empty()) {
      // A graph that is one loop offers no choice; its first node serves as the place where the loop closes.
      decisionOf_[0] = 0;
      decisions_.push_back(0);
    }
    graph_.decisionAt_.assign(library_.frames.frameCount(), kNone);
    for (std::size_t n = 0; n < decisionOf_.size(); ++n)
      graph_.decisionAt_[library_.graph.nodes[n].value] = decisionOf_[n];
  }

  void addWaysFrom(std::uint32_t node) {
    std::vector<SearchEdge> ways;
    for (const std::uint32_t link : linksFrom_[node]) {
      for (SearchEdge way : waysAlong(links_[link], 0)) {
        way.from = decisionOf_[node];
        ways.push_back(way);
      }
    }
    // A node where nothing else is bent needs its bent transitions.
    const bool bendsOthers = std::any_of(ways.begin(), ways.end(), [](const SearchEdge& way) {
      return way.bendRadians > 0.0 && way.transitions == 0;
    });
    const auto usualEnd = std::stable_partition(ways.begin(), ways.end(), [&](const SearchEdge& way) {
      return !bendsOthers || way.bendRadians == 0.0 || way.transitions == 0;
    });
    const auto first = static_cast<std::uint32_t>(graph_.edges_.size());
    graph_.firstEdge_.push_back(first);
    graph_.usualEnd_.push_back(first + static_cast<std::uint32_t>(usualEnd - ways.begin()));
    graph_.edges_.insert(graph_.edges_.end(), ways.begin(), ways.end());
  }

  void indexByTarget() {
    graph_.firstInto_.assign(graph_.nodeCount() + 1, 0);
    for (const SearchEdge& edge : graph_.edges_)
      if (edge.to != kNone) ++graph_.firstInto_[edge.to + 1];
    std::partial_sum(graph_.firstInto_.begin(), graph_.firstInto_.end(), graph_.firstInto_.begin());
    graph_.edgesInto_.resize(graph_.firstInto_.back());
    std::vector<std::uint32_t> free(graph_.firstInto_.begin(), graph_.firstInto_.end() - 1);
    for (const SearchEdge& edge : graph_.edges_)
      if (edge.to != kNone) graph_.edgesInto_[free[edge.to]++] = graph_.indexOf(edge);
  }

  /// The ways along a link from a position on it: as captured, and bent to either side where they lead on.
  std::vector<SearchEdge> waysAlong(const Link& link, std::uint32_t begin) {
    const SearchEdge captured = follow(link, begin);
    const Angle bend = bendOf(captured);
    if (captured.to == kNone || bend * captured.lengthMetres < kLeastBend) return {captured};
    return {captured, follow(link, begin, bend), follow(link, begin, -bend)};
  }

  Angle bendOf(const SearchEdge& way) const {
    const double metresPerSecond =
        way.lengthMetres * library_.frames.framesPerSecond / static_cast<double>(way.sampleCount);
    return std::min(SearchGraph::kBendPerMetre,
                    Angle::radians(SearchGraph::kBendAcceleration / (metresPerSecond * metresPerSecond)));
  }

  /// Follows a link from a position on it, and what comes after, to the next decision; bent all along.
  SearchEdge follow(const Link& first, std::uint32_t begin, Angle turnPerMetre = {}) {
    SearchEdge way;
    way.firstSample = static_cast<std::uint32_t>(graph_.samples_.size());
    way.firstStep = static_cast<std::uint32_t>(graph_.steps_.size());
    const Link* link = &first;
    for (;;) {
      graph_.steps_.push_back({link->piece, begin, link->piece.frames, turnPerMetre});
      appendSamples(*link, graph_.steps_.back(), way);
      if (link->piece.kind == EdgeKind::kTransition) {
        ++way.transitions;
        way.transitionDistanceMetres += static_cast<double>(link->piece.distanceMetres);
      }
      way.to = link->to == kNone ? kNone : decisionOf_[link->to];
      if (way.to != kNone || link->to == kNone) break;
      link = &links_[linksFrom_[link->to].front()];
      begin = 0;
    }
    way.sampleCount = static_cast<std::uint32_t>(graph_.samples_.size()) - way.firstSample;
    way.stepCount = static_cast<std::uint32_t>(graph_.steps_.size()) - way.firstStep;
    return way;
  }

  /// Lays a step out behind the end of a way.
  void appendSamples(const Link& link, const WalkStep& step, SearchEdge& way) {
    const FloorTransform wayFromLink = way.end * link.track[step.begin].inverse();
    for (std::uint32_t p = step.begin + 1; p <= step.end; ++p) {
      const FloorTransform going = link.track[p - 1].inverse() * link.track[p];
      const double metres = going.translation.norm();
      way.lengthMetres += metres;
      way.bendRadians += std::abs(step.turnPerMetre.radians()) * metres;
      way.end = step.turnPerMetre == Angle{} ? wayFromLink * link.track[p]
                                             : way.end * bentStep(going, step.turnPerMetre);
      if (way.settledSample == kNone && link.piece.kind == EdgeKind::kClipPiece &&
          standing_[link.piece.from.value + p] == Standing::kSettled) {
        way.settledSample = static_cast<std::uint32_t>(graph_.samples_.size()) - way.firstSample;
        way.settledEnd = way.end;
      }
      way.strain += static_cast<double>(strains_[capturedFrameAt(link.piece, p)]);
      graph_.samples_.push_back(way.end.translation.cast<float>());
      graph_.headings_.push_back(way.end.heading.direction().cast<float>());
    }
  }

  void addStartsOn(const Link& link) {
    for (std::uint32_t p = 0; p < link.piece.frames; ++p) {
      const bool stands = standsAt(link, p);
      const bool offered = stands ? p % kStandingStartStride == 0 && !standsStill(link, p)
                                  : movingFrames_++ % kMovingStartStride == 0;
      if (!offered) continue;
      const bool usual = stands || movingStarts_++ % 2 == 0;
      for (const SearchEdge& way : waysAlong(link, p))
        (usual ? graph_.starts_ : rareStarts_).push_back({way, stands});
      graph_.canStartStanding_ = graph_.canStartStanding_ || stands;
    }
  }

  bool standsAt(const Link& link, std::uint32_t p) const {
    const std::uint32_t later = std::min(p + kStandsOn, link.piece.frames);
    return standing_[link.piece.from.value + p] != Standing::kNo &&
           standing_[link.piece.from.value + later] != Standing::kNo;
  }

  /// Whether a walk that begins here had better begin with the next frame that is offered.
  bool standsStill(const Link& link, std::uint32_t p) const {
    const std::uint32_t next = p + kStandingStartStride;
    if (next >= link.piece.frames || !standsAt(link, next)) return false;
    const FloorTransform moved = link.track[p].inverse() * link.track[next];
    return moved.translation.norm() < kStillMetres && moved.heading.cos > Heading::fromAngle(kStillTurn).cos;
  }

  void addStarts() {
    const std::vector<FrameIndex>& nodes = library_.graph.nodes;
    for (const Link& link : links_) {
      if (link.piece.kind == EdgeKind::kClipPiece && link.to != kNone) addStartsOn(link);
    }
    for (std::size_t n = 0; n < nodes.size(); ++n) {
      std::size_t first = library_.clipOf(nodes[n]).firstFrame;
      if (n > 0 && nodes[n - 1].value >= first) continue;
      for (const Jerk& jerk : jerks_)
        if (jerk.frame.value >= first && jerk.frame < nodes[n]) first = jerk.frame.value + 1;
      if (nodes[n].value == first) continue;
      const MotionPiece runIn = clipPiece(FrameIndex(first), nodes[n]);
      addStartsOn({runIn, pieceTrack(library_, runIn), static_cast<std::uint32_t>(n)});
    }
    graph_.usualStartCount_ = graph_.starts_.size();
    graph_.starts_.insert(graph_.starts_.end(), rareStarts_.begin(), rareStarts_.end());
  }

  const MotionLibrary& library_;
  SearchGraph& graph_;
  std::vector<Standing> standing_;
  std::vector<Jerk> jerks_;     ///< The graph avoids them; ways outside of it have to as well.
  std::vector<float> strains_;  ///< Of each frame of the library.
  std::vector<Link> links_;
  std::vector<std::vector<std::uint32_t>> linksFrom_;  ///< For each node of the library's graph.
  std::vector<std::uint32_t> decisionOf_;              ///< Library node -> decision node.
  std::vector<std::uint32_t> decisions_;               ///< Decision node -> library node.
  std::uint32_t movingFrames_ = 0;                     ///< Seen so far that a walk could begin with,
  std::uint32_t movingStarts_ = 0;                     ///< and offered.
  std::vector<SearchStart> rareStarts_;
};

SearchGraph::SearchGraph(const MotionLibrary& library, const MotionLimits& limits) {
  SearchGraphBuilder(library, limits, *this).build();
}

std::span<const SearchEdge> SearchGraph::edgesFrom(std::size_t node) const {
  return std::span(edges_).subspan(firstEdge_[node], firstEdge_[node + 1] - firstEdge_[node]);
}

std::span<const SearchEdge> SearchGraph::usualEdgesFrom(std::size_t node) const {
  return std::span(edges_).subspan(firstEdge_[node], usualEnd_[node] - firstEdge_[node]);
}

std::span<const std::uint32_t> SearchGraph::edgesInto(std::size_t node) const {
  return std::span(edgesInto_).subspan(firstInto_[node], firstInto_[node + 1] - firstInto_[node]);
}

std::span<const Eigen::Vector2f> SearchGraph::samplesOf(const SearchEdge& edge) const {
  return std::span(samples_).subspan(edge.firstSample, edge.sampleCount);
}

std::span<const Eigen::Vector2f> SearchGraph::headingsOf(const SearchEdge& edge) const {
  return std::span(headings_).subspan(edge.firstSample, edge.sampleCount);
}

std::span<const WalkStep> SearchGraph::stepsOf(const SearchEdge& edge) const {
  return std::span(steps_).subspan(edge.firstStep, edge.stepCount);
}

}  // namespace stridegraph
