#include "engine/handout_page.h"

#include <fmt/format.h>

#include "image/svg.h"

namespace ps {
namespace {

constexpr std::string_view style_sheet =
    "body{font:16px/1.5 Georgia,serif;max-width:46em;margin:2em auto;padding:0 1em;color:#111}"
    "h1,h2,h3,figcaption,table,.question,.box{font-family:Helvetica,Arial,sans-serif}"
    "h1{margin:0 0 .2em}h2{margin:1.2em 0 .3em}h1,h2,h3{line-height:1.2}"
    ".source,figcaption,footer{color:#555;font-size:85%}.place{color:#555;float:right;font-weight:normal;font-"
    "size:55%;margin-top:.4em}"
    ".person{display:flex;gap:2em;margin:0 0 1em}.person span{flex:1;border-bottom:1px solid #111}"
    ".person span+span{flex:.4}"
    ".pictures{display:flex;gap:1em;margin:.6em 0}figure{flex:1;margin:0;min-width:0}"
    "img{display:block;width:auto;height:auto;max-width:100%;box-sizing:border-box;border:1px solid #bbb;"
    "image-rendering:pixelated}"
    ".drawing{margin:.6em 0;break-inside:avoid}.drawing svg{display:block;max-width:100%;height:auto;margin:0 auto}"
    ".covered{border:1px solid #999;padding:20% 1em;text-align:center}"
    ".box{background:#eee;padding:.3em 1em;margin:.8em 0;font-size:90%}.box p,.box ul{margin:.3em 0}"
    ".look{border-left:3px solid #999;padding-left:1em}"
    "table{border-collapse:collapse;font-size:85%;width:100%}td,th{border:1px solid #bbb;padding:.2em .5em;"
    "text-align:left;vertical-align:top}.question{border:1px solid #555;padding:.3em 1em;margin:.8em 0;font-size:95%}"
    ".question ul{list-style:none;padding-left:0}.question li{margin:.3em 0 .3em 1.7em;text-indent:-1.7em}"
    ".tick{display:inline-block;width:.9em;height:.9em;border:1px solid #111;margin-right:.7em;vertical-align:-.1em}"
    "pre{font:80%/1.35 monospace;white-space:pre-wrap;overflow-wrap:anywhere}"
    ".write{border-bottom:1px solid #111;display:inline-block;width:12em}code{overflow-wrap:anywhere}"
    "@page{size:A4;margin:15mm 16mm 17mm;@bottom-right{content:counter(page) \" of \" counter(pages);"
    "font:9pt Helvetica,Arial,sans-serif;color:#555}}"
    "@media print{body{margin:0;padding:0;max-width:none;font-size:10pt;line-height:1.38}"
    "img{max-height:56mm}.drawing svg{width:auto;max-height:44mm}.covered{padding:12% 1em}p{margin:.5em "
    "0;break-inside:avoid}"
    ".page{break-before:page}h1,h2,h3{break-after:avoid}.pictures,.question,.box,ul,tr{break-inside:avoid}"
    "ul,.pictures{break-before:avoid}"
    ".question.long{break-inside:auto}}";

}  // namespace

std::string handout_page(const std::string& title, const std::string& body, const std::string& footer) {
  return fmt::format(
      "<!DOCTYPE html>\n<html lang=\"en\" xmlns=\"http://www.w3.org/1999/xhtml\"><head><meta charset=\"utf-8\"/>"
      "<meta name=\"viewport\" content=\"width=device-width\"/>\n<title>{}</title>\n<style>{}</style></head>\n<body>\n"
      "{}<footer><p>{}</p></footer>\n</body></html>\n",
      xml_escaped(title), style_sheet, body, footer);
}

}  // namespace ps
