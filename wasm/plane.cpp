#include "plane.h"

#include <span>
#include <vector>

#include "inspection.h"
#include "marshal.h"
#include "options.h"
#include "plane/plane_picture.h"

namespace plateau {

using emscripten::val;
using marshal::copied;

namespace {

Result<PlaneScene> scene_of(const val& source) {
    PlaneScene scene;
    scene.witnesses.coordinates = emscripten::convertJSArrayToNumberVector<double>(source["witnesses"]);
    scene.landmarks.coordinates = emscripten::convertJSArrayToNumberVector<double>(source["landmarks"]);
    if (const val nu = source["nu"]; marshal::given(nu)) {
        auto entries = marshal::counts_of(nu, "Each entry of nu");
        if (!entries) return entries.error();
        scene.nu = std::move(entries).value();
    }
    if (const val delaunay = source["delaunay"]; marshal::given(delaunay)) scene.within_delaunay = delaunay.as<bool>();
    return scene;
}

Result<PlaneBox> box_of(const val& source) {
    const auto sides = emscripten::convertJSArrayToNumberVector<double>(source["box"]);
    if (sides.size() == 4) return PlaneBox{sides[0], sides[1], sides[2], sides[3]};
    return Error{ErrorCode::InvalidOption, "The box takes four numbers: left, bottom, right, top."};
}

/// Places in the array of landmarks: the core counts them from 1.
template <class Simplex>
val places_of(const std::vector<Simplex>& simplices) {
    std::vector<std::uint32_t> places;
    for (const Simplex& simplex : simplices) {
        for (const Step landmark : simplex) places.push_back(landmark - 1);
    }
    return copied(std::span<const std::uint32_t>(places));
}
val places_of(const std::vector<Step>& landmarks) {
    std::vector<std::uint32_t> places;
    for (const Step landmark : landmarks) places.push_back(landmark - 1);
    return copied(std::span<const std::uint32_t>(places));
}

val lists_of(const WitnessLists& lists) {
    val out = val::object();
    out.set("first", copied(std::span<const std::uint32_t>(lists.first)));
    out.set("witnesses", copied(std::span<const std::uint32_t>(lists.witnesses)));
    return out;
}

val polygons_of(const PlanePolygons& polygons) {
    val out = val::object();
    out.set("first", copied(std::span<const std::uint32_t>(polygons.first_corner)));
    out.set("corners", copied(std::span<const double>(polygons.corners)));
    return out;
}

}  // namespace

val plane_picture_of(const val& source) {
    return marshal::guarded([&] {
        const auto scene = scene_of(source);
        if (!scene) return marshal::failed(scene.error());
        const auto box = box_of(source);
        if (!box) return marshal::failed(box.error());
        const auto drawn = plane_picture(scene.value(), box.value());
        if (!drawn) return marshal::failed(drawn.error());
        const PlanePicture& picture = drawn.value();
        val out = val::object();
        out.set("delaunayEdges", places_of(picture.delaunay_edges));
        out.set("delaunayTriangles", places_of(picture.delaunay_triangles));
        out.set("listLength", picture.list_length);
        out.set("lists", places_of(picture.lists));
        out.set("vertices", places_of(picture.vertices));
        out.set("edges", places_of(picture.edges));
        out.set("triangles", places_of(picture.triangles));
        out.set("vertexWitnesses", lists_of(picture.witnesses[0]));
        out.set("edgeWitnesses", lists_of(picture.witnesses[1]));
        out.set("triangleWitnesses", lists_of(picture.witnesses[2]));
        out.set("betti", copied(std::span<const std::uint32_t>(picture.betti)));
        out.set("cells", polygons_of(picture.cells));
        out.set("pairCells", polygons_of(picture.pair_cells));
        val answer = val::object();
        answer.set("kind", std::string("planePicture"));
        answer.set("picture", out);
        return answer;
    });
}

val plane_why_of(const val& source, const val& vertices) {
    return marshal::guarded([&] {
        const auto scene = scene_of(source);
        if (!scene) return marshal::failed(scene.error());
        auto places = marshal::counts_of(vertices, "Each landmark");
        if (!places) return marshal::failed(places.error());
        std::vector<Step> landmarks = std::move(places).value();
        for (Step& landmark : landmarks) ++landmark;
        const auto inspection = plane_why(scene.value(), std::move(landmarks));
        if (!inspection) return marshal::failed(inspection.error());
        val answer = val::object();
        answer.set("kind", std::string("inspection"));
        answer.set("inspection", marshal::inspection_of(inspection.value(), 0));
        return answer;
    });
}

}  // namespace plateau
