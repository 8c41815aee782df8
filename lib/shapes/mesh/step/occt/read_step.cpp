// read-step - writes the faces of a STEP file as triangles; run by filum::mesh::step::read, not by users
//
// read-step DEFLECTION ANGLE (mm and degrees)
//
// The file is standard input. Descriptor 3 receives the answer that step/answer.hpp describes. Exit 0 if an answer was
// written, a failure included.
#include "mesh/step/answer.hpp"

#include <BRepBndLib.hxx>
#include <BRepBuilderAPI_Sewing.hxx>
#include <BRepMesh_IncrementalMesh.hxx>
#include <BRep_Tool.hxx>
#include <Bnd_Box.hxx>
#include <Message.hxx>
#include <Message_Messenger.hxx>
#include <Poly_PolygonOnTriangulation.hxx>
#include <Poly_Triangulation.hxx>
#include <STEPControl_Reader.hxx>
#include <Standard_Failure.hxx>
#include <StepData_StepModel.hxx>
#include <StepShape_FaceSurface.hxx>
#include <TopExp.hxx>
#include <TopExp_Explorer.hxx>
#include <TopTools_DataMapOfShapeInteger.hxx>
#include <TopTools_IndexedDataMapOfShapeListOfShape.hxx>
#include <TopTools_IndexedMapOfShape.hxx>
#include <TopoDS.hxx>
#include <TopoDS_Edge.hxx>
#include <TopoDS_Face.hxx>
#include <TopoDS_Vertex.hxx>

#include <array>
#include <csignal>
#include <cstdio>
#include <cstdlib>
#include <iostream>
#include <string>
#include <sys/prctl.h>
#include <sys/resource.h>
#include <unistd.h>
#include <vector>

namespace filum::mesh::step {

namespace {

constexpr std::uint32_t kNone = ~std::uint32_t{0};
constexpr double kSewn = 0.01; // mm: free borders of faces that are nearer are joined

struct Mesh {
    std::vector<std::array<double, 3>> vertices;
    std::vector<std::array<std::uint32_t, 3>> triangles;
    std::vector<std::uint32_t> faces;
    Answer head;

    std::uint32_t add(const gp_Pnt& p) {
        vertices.push_back({p.X(), p.Y(), p.Z()});
        return static_cast<std::uint32_t>(vertices.size() - 1);
    }
};

// Maps the vertices and edges of the shape to vertices of the mesh, so that faces that share an edge share its
// vertices.
class Joints {
  public:
    Joints(const TopoDS_Shape& shape, Mesh& mesh) : mesh_(mesh) {
        TopExp::MapShapes(shape, TopAbs_VERTEX, vertices_);
        TopExp::MapShapes(shape, TopAbs_EDGE, edges_);
        at_vertex_.assign(static_cast<std::size_t>(vertices_.Extent()) + 1, kNone);
        on_edge_.resize(static_cast<std::size_t>(edges_.Extent()) + 1);
    }

    // Assigns mesh vertices to the nodes of `face` that lie on an edge.  `to` has an entry per node.
    void join(const TopoDS_Edge& edge, const Handle(Poly_Triangulation) & face, const TopLoc_Location& place,
              std::vector<std::uint32_t>& to) {
        const Handle(Poly_PolygonOnTriangulation) line = BRep_Tool::PolygonOnTriangulation(edge, face, place);
        if (line.IsNull()) return;
        const TopoDS_Edge forward = TopoDS::Edge(edge.Oriented(TopAbs_FORWARD));
        const TopoDS_Vertex begin = TopExp::FirstVertex(forward), end = TopExp::LastVertex(forward);
        auto& inner = on_edge_[static_cast<std::size_t>(edges_.FindIndex(edge))];
        const int count = line->NbNodes();
        const auto node = [&](int i) { return static_cast<std::size_t>(line->Node(i)); };
        const auto point = [&](int i) { return face->Node(line->Node(i)).Transformed(place.Transformation()); };
        if (BRep_Tool::Degenerated(edge) && !begin.IsNull()) { // a pole: the whole edge is one point
            for (int i = 1; i <= count; ++i) to[node(i)] = vertex(begin);
            return;
        }
        if (inner.empty())
            for (int i = 1; i <= count; ++i) {
                const bool first = i == 1 && !begin.IsNull(), last = i == count && !end.IsNull();
                inner.push_back(first ? vertex(begin) : last ? vertex(end) : mesh_.add(point(i)));
            }
        if (inner.size() != static_cast<std::size_t>(count)) return; // the other face meshed this edge differently
        for (int i = 1; i <= count; ++i) to[node(i)] = inner[static_cast<std::size_t>(i) - 1];
    }

  private:
    std::uint32_t vertex(const TopoDS_Vertex& v) {
        auto& id = at_vertex_[static_cast<std::size_t>(vertices_.FindIndex(v))];
        if (id == kNone) id = mesh_.add(BRep_Tool::Pnt(v));
        return id;
    }

    Mesh& mesh_;
    TopTools_IndexedMapOfShape vertices_, edges_;
    std::vector<std::uint32_t> at_vertex_;
    std::vector<std::vector<std::uint32_t>> on_edge_;
};

void add_face(const TopoDS_Face& face, std::uint32_t id, Joints& joints, Mesh& mesh) {
    TopLoc_Location place;
    const Handle(Poly_Triangulation) triangles = BRep_Tool::Triangulation(face, place);
    if (triangles.IsNull() || triangles->NbTriangles() == 0) {
        if (mesh.head.unmeshed++ == 0) {
            Bnd_Box box;
            BRepBndLib::Add(face, box);
            if (!box.IsVoid()) {
                mesh.head.x = (box.CornerMin().X() + box.CornerMax().X()) / 2;
                mesh.head.y = (box.CornerMin().Y() + box.CornerMax().Y()) / 2;
            }
        }
        return;
    }
    std::vector<std::uint32_t> to(static_cast<std::size_t>(triangles->NbNodes()) + 1, kNone);
    for (TopExp_Explorer edge(face, TopAbs_EDGE); edge.More(); edge.Next())
        joints.join(TopoDS::Edge(edge.Current()), triangles, place, to);
    for (int n = 1; n <= triangles->NbNodes(); ++n) {
        auto& id_of_node = to[static_cast<std::size_t>(n)];
        if (id_of_node == kNone) id_of_node = mesh.add(triangles->Node(n).Transformed(place.Transformation()));
    }
    const bool turned = (face.Orientation() == TopAbs_REVERSED) != place.Transformation().IsNegative();
    for (int t = 1; t <= triangles->NbTriangles(); ++t) {
        int n[3];
        triangles->Triangle(t).Get(n[0], n[1], n[2]);
        std::array<std::uint32_t, 3> corners{};
        for (std::size_t k = 0; k < 3; ++k) corners[k] = to[static_cast<std::size_t>(n[k])];
        if (corners[0] == corners[1] || corners[1] == corners[2] || corners[2] == corners[0]) continue; // at a pole
        if (turned) std::swap(corners[1], corners[2]);
        mesh.triangles.push_back(corners);
        mesh.faces.push_back(id);
    }
}

// True if an edge belongs to exactly one face, and only once to that face.
bool has_free_edge(const TopoDS_Shape& shape) {
    TopTools_IndexedDataMapOfShapeListOfShape faces_of;
    TopExp::MapShapesAndAncestors(shape, TopAbs_EDGE, TopAbs_FACE, faces_of);
    for (int i = 1; i <= faces_of.Extent(); ++i) {
        const TopoDS_Edge& edge = TopoDS::Edge(faces_of.FindKey(i));
        const auto& faces = faces_of.FindFromIndex(i);
        if (faces.Extent() == 1 && !BRep_Tool::Degenerated(edge) &&
            !BRep_Tool::IsClosed(edge, TopoDS::Face(faces.First())))
            return true;
    }
    return false;
}

using Ids = TopTools_DataMapOfShapeInteger;

// Sews faces that some programs write without shared edges.  Returns the shape and the ids of its faces.
TopoDS_Shape sewn(const TopoDS_Shape& shape, const TopTools_IndexedMapOfShape& faces, Ids& ids) {
    BRepBuilderAPI_Sewing sewing(kSewn);
    const bool needed = has_free_edge(shape);
    if (needed) {
        sewing.Add(shape);
        sewing.Perform();
    }
    for (int i = 1; i <= faces.Extent(); ++i)
        ids.Bind(needed && sewing.IsModifiedSubShape(faces(i)) ? sewing.ModifiedSubShape(faces(i)) : faces(i), i);
    return needed ? sewing.SewedShape() : shape;
}

// Reads the shape.  Throws a std::string with the fault.
Mesh read(double deflection, double angle_deg) {
    STEPControl_Reader reader;
    if (reader.ReadStream("part.step", std::cin) != IFSelect_RetDone)
        throw std::string("OpenCASCADE finds no STEP model in it; export it again, or as STL");
    reader.TransferRoots();
    const TopoDS_Shape given = reader.OneShape();
    TopTools_IndexedMapOfShape faces;
    if (!given.IsNull()) TopExp::MapShapes(given, TopAbs_FACE, faces);
    const auto model = reader.StepModel();
    int written = 0;
    for (int i = 1; i <= model->NbEntities(); ++i)
        written += model->Value(i)->IsKind(STANDARD_TYPE(StepShape_FaceSurface)) ? 1 : 0;
    if (faces.IsEmpty())
        throw std::string(written > 0 ? "OpenCASCADE can read none of its faces; export it again, or as STL"
                                      : "it holds no face; export the part as a solid or a surface");
    Ids ids;
    const TopoDS_Shape shape = sewn(given, faces, ids);
    BRepMesh_IncrementalMesh(shape, deflection, Standard_False, angle_deg * M_PI / 180, Standard_False);
    Mesh out;
    out.head.unread = written > faces.Extent() ? static_cast<std::uint64_t>(written - faces.Extent()) : 0;
    Joints joints(shape, out);
    const auto id_of = [&](const TopoDS_Shape& face) {
        return static_cast<std::uint32_t>(ids.IsBound(face) ? ids.Find(face) : 0);
    };
    // Counts occurrences: a face between two bodies belongs to both, once in each orientation.
    for (TopExp_Explorer face(shape, TopAbs_FACE); face.More(); face.Next())
        add_face(TopoDS::Face(face.Current()), id_of(face.Current()), joints, out);
    if (out.triangles.empty()) throw std::string("OpenCASCADE can mesh none of its faces; export it again, or as STL");
    out.head.vertices = out.vertices.size();
    out.head.triangles = out.triangles.size();
    return out;
}

template <class T>
void put(std::FILE* to, const T* data, std::size_t count) {
    if (std::fwrite(data, sizeof(T), count, to) != count) ::_exit(1);
}

void fail(std::FILE* to, const std::string& text) {
    Answer head;
    head.failed = 1;
    head.vertices = text.size();
    put(to, &head, 1);
    put(to, text.data(), text.size());
}

} // namespace

} // namespace filum::mesh::step

int main(int argc, char** argv) {
    using namespace filum::mesh::step;
    ::prctl(PR_SET_PDEATHSIG, SIGKILL);
    const rlimit none{0, 0};
    ::setrlimit(RLIMIT_CORE, &none); // no core dump if OpenCASCADE crashes on a damaged file
    std::FILE* out = argc == 3 ? ::fdopen(3, "wb") : nullptr;
    if (out == nullptr) return 2;
    Message::DefaultMessenger()->ChangePrinters().Clear();
    try {
        const Mesh mesh = read(std::atof(argv[1]), std::atof(argv[2]));
        put(out, &mesh.head, 1);
        put(out, mesh.vertices.data(), mesh.vertices.size());
        put(out, mesh.triangles.data(), mesh.triangles.size());
        put(out, mesh.faces.data(), mesh.faces.size());
    } catch (const std::string& text) {
        fail(out, text);
    } catch (const Standard_Failure& e) {
        fail(out, std::string("OpenCASCADE fails: ") + e.DynamicType()->Name() + "; export it again, or as STL");
    } catch (const std::exception& e) {
        fail(out, std::string("OpenCASCADE fails: ") + e.what() + "; export it again, or as STL");
    }
    ::_exit(std::fclose(out) == 0 ? 0 : 1); // exits at once, as its libraries take long to unload
}
