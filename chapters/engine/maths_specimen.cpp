#include "engine/maths_specimen.h"

namespace ps {

std::string_view maths_specimen() {
  return R"(### Within the text

The ray $O + t\,\vec D$ meets the sphere where $a t^2 + b t + c = 0$, with $a = \vec D \cdot \vec D$, and the *discriminant*
$b^2 - 4 a c$ gives the number of intersections. A weight $\alpha_i \ge 0$ of vertex $i$, a unit vector
$\hat n = \vec n / \lVert \vec n \rVert$, half $\frac{1}{2}$, $\sqrt{2}$ and $x'_{n+1}$ stand on the line's baseline.

### Scripts, fractions, roots

$$t_{1,2} = \frac{-b \pm \sqrt{b^2 - 4 a c}}{2 a} \quad x^{2^n} + x_{i_j} \quad \frac{1}{1 + \frac{1}{z}} \quad \sqrt[3]{\frac{x + 1}{y}}$$

### Vectors, norms, fences

$$\vec N \cdot \vec L = \lVert \vec N \rVert \, \lVert \vec L \rVert \cos\theta \quad \bar x \quad \hat{AB} \quad \vec{PQ} \quad \mathbf{R} \quad \mathrm{d}x \quad \|v\|$$

$$\left( \frac{a}{b} \right) \left[ \frac{a}{b} \right] \left\{ \frac{a}{b} \right\} \left| \frac{a}{b} \right| \left\| \frac{a}{b} \right\|
\left\lfloor \frac{a}{b} \right\rfloor \left\lceil \frac{a}{b} \right\rceil \left\langle \frac{a}{b} \right\rangle \left. \frac{a}{b} \right|_{x=0}$$

### Matrices and cases

$$\begin{pmatrix} x' \\ y' \\ 1 \end{pmatrix} = \begin{bmatrix} \cos\varphi & -\sin\varphi & t_x \\ \sin\varphi & \cos\varphi & t_y \\ 0 & 0 & 1 \end{bmatrix}
\begin{pmatrix} x \\ y \\ 1 \end{pmatrix} \quad \begin{vmatrix} a & b \\ c & d \end{vmatrix} \quad \begin{matrix} 1 & 2 \end{matrix}
\quad f(x) = \begin{cases} x^n & \text{if } x > 0 \\ 0 & \text{otherwise} \end{cases}$$

### Sums, products, integrals, limits

$$I = I_A + \sum_{i=1}^{n} I_i \max(0, \vec N \cdot \vec L_i) \quad \prod_{k=1}^{m} a_k \quad \int_0^1 f(x)\,\mathrm{d}x \quad \lim_{z \to \infty} \frac{1}{z} \quad \min_i t_i$$

In the text: $\sum_{i=1}^n w_i = 1$, $\prod_k a_k$, $\int_a^b f$.

### Signs

$\alpha\beta\gamma\delta\epsilon\zeta\eta\theta\kappa\lambda\mu\nu\xi\pi\rho\sigma\tau\varphi\phi\chi\psi\omega$
$\Gamma\Delta\Theta\Lambda\Xi\Pi\Sigma\Phi\Psi\Omega$ $\ell\infty\partial\emptyset\;45\degree\,f\prime$ $\ldots$ $\cdots$ $\forall\exists$ $\%\#$

$a + b - c \cdot d \times e \div f \pm g \circ h \otimes i \oplus j \cap k \cup l / m : n$
$a = b < c > d \le e \ge f \ne g \approx h \equiv i \sim j \in k \notin l \subset m \perp n \parallel o$
$a \to b \gets c \mapsto d \Rightarrow e \iff f$ $n! \; p? \; \{q\}, [r]; (s)\ t$ $\lfloor x \rfloor \lceil x \rceil \langle x \rangle \lvert x \rvert$

$\sin\cos\tan\arcsin\arccos\arctan\log\ln\exp\det \operatorname{clamp} 3.14$
)";
}

}  // namespace ps
